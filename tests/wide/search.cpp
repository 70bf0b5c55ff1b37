#include "search.hpp"

#include "factor.hpp"

namespace glint::wide {

std::vector<Input> at_remainder(const Exact& exact, int n, std::int64_t r) {
    const std::int64_t m = n - 1;
    const Integer one = Integer{1} << exact.F;
    const Integer product = n * (Integer{1} << (exact.F + exact.S)) - m * Integer{r};
    std::vector<Input> out;
    for (const Big divisor : divisors(static_cast<Big>(product))) {
        const auto D = static_cast<Integer>(divisor);
        const Integer E = product / D;
        if (D < one || D > n * one || (n * one - D) % m != 0 || (E - (Integer{1} << exact.S)) % m != 0) continue;
        out.push_back({n, static_cast<std::int64_t>((n * one - D) / m)});
    }
    std::sort(out.begin(), out.end());
    return out;
}

std::vector<Input> of_quotient(const Exact& exact, int n, std::int64_t quotient) {
    // The quotient is q or more from C 2^S >= q D on, which is C (2^S + q m) >= q n 2^F.
    const Integer one = Integer{1} << exact.F;
    const auto least = [&](std::int64_t q) {
        const Integer E = (Integer{1} << exact.S) + Integer{q} * (n - 1);
        return static_cast<std::int64_t>((Integer{q} * n * one + E - 1) / E);
    };
    const std::int64_t first = least(quotient);
    const std::int64_t beyond = std::min(least(quotient + 1), static_cast<std::int64_t>(one) + 1);
    std::vector<Input> out;
    if (first >= beyond) return out;
    for (const std::int64_t C : {first - 1, first, beyond - 1, beyond}) {
        if (C >= 0 && C <= one) out.push_back({n, C});
    }
    return out;
}

}  // namespace glint::wide
