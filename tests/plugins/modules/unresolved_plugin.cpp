// SPDX-License-Identifier: BSD-3-Clause
/** A plugin built for something that is not there. */
extern "C" int functionOfAnotherVoxeland();

extern "C" int callsIt()
{
    return functionOfAnotherVoxeland();
}
