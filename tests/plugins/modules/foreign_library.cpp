// SPDX-License-Identifier: BSD-3-Clause
/** A library that is no plugin of ours: loads, and registers nothing. */
extern "C" int foreignFunction()
{
    return 42;
}
