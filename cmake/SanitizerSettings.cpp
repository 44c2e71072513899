// SPDX-License-Identifier: BSD-3-Clause
/** What the sanitizers must know of this project, in each program that they are built into. */

extern "C" const char* __asan_default_options()
{
    return "allocator_may_return_null=1:max_allocation_size_mb=1024";
}

extern "C" const char* __lsan_default_suppressions()
{
    // MRPT loses the definition of a map whose settings are refused by an exception.
    return "leak:mrpt::maps::TSetOfMetricMapInitializers::loadFromConfigFile\n";
}

extern "C" const char* __ubsan_default_options()
{
    return "print_stacktrace=1";
}
