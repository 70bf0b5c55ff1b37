// The contract of `bps` (docs/lobes/bps.md) once more, apart from model/: in 128-bit integers, the constants from their
// decimal digits; and the real function f_bps by integers, with a stated error.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>

#include <fmt/format.h>

#include "glint/error.hpp"
#include "glint/reference.hpp"

namespace glint::wide {

__extension__ using Integer = __int128;

/// Fraction bits of the real function's values.
constexpr int real_bits = 60;
/// Each of them is wrong by less than 2^-57: s is cut by less than 2^-60, where |P'| < 1.46; four constants are rounded
/// by 2^-61 at most; three products are cut by less than 2^-60; and no factor is above 1: 6.46 * 2^-60 together.
constexpr std::int64_t real_error = 8;

class Exact {
public:
    /// The numbers of a profile: F, S, K, O. Legal: those that the model takes.
    explicit Exact(std::span<const int, 4> numbers) : F(numbers[0]), S(numbers[1]), K(numbers[2]), O(numbers[3]) {
        const auto& published = reference::bps_constants;
        fixed_ = {at(published.a, K), at(published.b, K), at(published.c1, K), at(published.d0, K)};
        real_ = {at(published.a, real_bits), at(published.b, real_bits), at(published.c1, real_bits),
                 at(published.d0, real_bits)};
    }

    const int F, S, K, O;

    Integer divisor(int n, std::int64_t C) const { return n * (Integer{1} << F) - (n - 1) * Integer{C}; }
    /// floor(C 2^real_bits / D), from which the quotient is cut.
    std::int64_t ratio(int n, std::int64_t C) const {
        return static_cast<std::int64_t>((Integer{C} << real_bits) / divisor(n, C));
    }
    std::int64_t quotient_of(std::int64_t ratio) const { return ratio >> (real_bits - S); }

    /// What the last rounding cuts: h2 q + d0 2^S + 2^(S+K-O-1).
    std::int64_t last_sum(std::int64_t quotient) const {
        const Integer h1 = fixed_.b + floor_shift(fixed_.a * quotient + half(S), S);
        const Integer h2 = fixed_.c1 + floor_shift(h1 * quotient + half(S), S);
        return static_cast<std::int64_t>(h2 * quotient + (fixed_.d0 << S) + half(S + K - O));
    }
    std::int64_t y_of_sum(std::int64_t last_sum) const {
        const Integer y = floor_shift(last_sum, S + K - O);
        return y < 0 ? 0 : static_cast<std::int64_t>(y);
    }

    /// max(0, P(s)) for s = ratio / 2^real_bits.
    std::int64_t real(std::int64_t ratio) const {
        const Integer h1 = real_.b + ((real_.a * ratio) >> real_bits);
        const Integer h2 = real_.c1 + ((h1 * ratio) >> real_bits);
        const Integer P = real_.d0 + ((h2 * ratio) >> real_bits);
        return P < 0 ? 0 : static_cast<std::int64_t>(P);
    }

    /// |y / 2^O - max(0, P(s))| at real_bits fraction bits, rounded up by real_error: never below the true error.
    std::int64_t error(std::int64_t y, std::int64_t ratio) const {
        return std::abs((y << (real_bits - O)) - real(ratio)) + real_error;
    }
    double in_ulps(std::int64_t error) const { return std::ldexp(static_cast<double>(error), O - real_bits); }

private:
    struct Constants {
        Integer a = 0, b = 0, c1 = 0, d0 = 0;
    };

    static Integer half(int bits) { return Integer{1} << (bits - 1); }
    static Integer floor_shift(Integer x, int bits) { return x >> bits; }  // C++20: the floor, for negative x too

    /// A constant of at most six decimals at `bits` fraction bits, to the nearest integer, halves away from zero.
    static Integer at(double value, int bits) {
        const double scaled = value * 1e6;
        const Integer millionths = std::llround(scaled);
        if (std::abs(scaled - static_cast<double>(millionths)) > 1e-6) {
            throw Error(fmt::format("constant {} has more than six decimals", value));
        }
        const Integer magnitude = millionths < 0 ? -millionths : millionths;
        const Integer rounded = ((magnitude << (bits + 1)) + 1'000'000) / 2'000'000;
        return millionths < 0 ? -rounded : rounded;
    }

    Constants fixed_, real_;
};

}  // namespace glint::wide
