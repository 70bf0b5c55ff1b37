// Divisors of numbers up to 2^100: by them the inputs next to a quotient boundary are found (search.hpp).
#pragma once

#include <vector>

namespace glint::wide {

__extension__ using Big = unsigned __int128;

/// All divisors of a number, in no order. Legal: 1 <= number < 2^80, so that the test of primes is exact.
std::vector<Big> divisors(Big number);

}  // namespace glint::wide
