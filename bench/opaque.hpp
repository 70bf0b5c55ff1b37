// A value that the compiler knows nothing of.
#pragma once

#include <benchmark/benchmark.h>

namespace glint::bench {

template <class T>
T opaque(T value) {
    benchmark::DoNotOptimize(value);
    return value;
}

}  // namespace glint::bench
