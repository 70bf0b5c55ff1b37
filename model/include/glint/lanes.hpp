// How a function asks for the vector lanes of the machine that it runs on.
#pragma once

// GLINT_LANES before a function that is one `#pragma omp simd` loop: on x86-64 Linux the compiler makes one clone for
// the base instruction set, one for AVX2 and one for AVX-512, and the loader picks. Elsewhere (on AArch64 the base has
// its lanes already; a sanitizer's runtime is not up yet when the loader picks) the plain function is all there is.
#if defined(__x86_64__) && defined(__ELF__) && defined(__GNUC__) && !defined(GLINT_SANITIZERS)
#define GLINT_LANES __attribute__((target_clones("default", "arch=haswell", "arch=skylake-avx512")))
#else
#define GLINT_LANES
#endif
