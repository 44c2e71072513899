// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// For plain loops over plain arrays, which compilers vectorize; the same results with and without
// AVX2. (With ThreadSanitizer the choice, made while the library is loaded, crashes.)
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define VOXELAND_WITH_AVX2 __attribute__((target_clones("avx2", "default")))
#else
#define VOXELAND_WITH_AVX2
#endif
