#pragma once

// Functions that are compiled for plain x86-64 and for AVX2; the program takes one of them when it starts. The
// sanitizers check them as they are.

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SCANWAY_FOR_EACH_CPU
#define SCANWAY_IN_ONE_PIECE
#else
#define SCANWAY_FOR_EACH_CPU [[gnu::target_clones("default", "avx2")]]
/// And with all that it calls in it.
#define SCANWAY_IN_ONE_PIECE [[gnu::flatten, gnu::target_clones("default", "avx2")]]
#endif
