// What the tests of several lobes ask of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "catch.hpp"
#include "glint/lobes.hpp"

namespace glint {

/// The code of an intermediate value; the test fails when there is none of that name.
inline std::int64_t value(const std::vector<Intermediate>& trace, std::string_view name) {
    const auto found = std::ranges::find(trace, name, &Intermediate::name);
    if (found == trace.end()) FAIL("no intermediate " << name);
    return found->code;
}

inline bool unsigned_bits(std::int64_t x, int bits) { return x >= 0 && x < std::int64_t{1} << bits; }
inline bool signed_bits(std::int64_t x, int bits) {
    return x >= -(std::int64_t{1} << (bits - 1)) && x < std::int64_t{1} << (bits - 1);
}

/// Exactly 1 at c = 1, for every n and shipped profile.
inline void check_peak(const Lobe& lobe) {
    for (const Profile& profile : shipped_profiles()) {
        const auto model = lobe.golden(profile);
        for (int n = 1; n <= max_n; ++n) {
            if (model->eval(n, profile.one()) != 1U << profile.O) FAIL(profile.name << " n " << n);
        }
    }
}

/// At every input of p8: at most 1, never falls when c grows, never rises when n grows.
inline void check_monotone_in_both(const Lobe& lobe) {
    const Profile p8 = parse_profile("p8");
    const auto model = lobe.golden(p8);
    std::vector<std::uint32_t> sharper(static_cast<std::size_t>(p8.one()) + 1);  // the results of n + 1
    for (int n = max_n; n >= 1; --n) {
        std::uint32_t before = 0;
        for (int C = 0; C <= p8.one(); ++C) {
            const std::uint32_t y = model->eval(n, C);
            std::uint32_t& narrow = sharper[static_cast<std::size_t>(C)];
            if (y < before || y < narrow || y > 1U << p8.O) FAIL("n " << n << " C " << C);
            before = y;
            narrow = y;
        }
    }
}

/// Of a lobe whose base is c for n of 1 to 6 and 8: c^n there, within the rounding.
inline void check_small_powers(const Lobe& lobe) {
    for (const Profile& profile : shipped_profiles()) {
        const auto model = lobe.golden(profile);
        for (const int n : {1, 2, 3, 4, 5, 6, 8}) {
            for (int C = 0; C <= profile.one(); C += profile.one() >> 16) {
                const double power = std::pow(std::ldexp(C, -profile.F), n);
                if (!(std::abs(model->eval(n, C) - std::ldexp(power, profile.O)) < 1.0)) {
                    FAIL(profile.name << " n " << n << " C " << C);
                }
            }
        }
    }
}

/// The real function of such a lobe at its ends.
inline void check_real_ends(const Lobe& lobe) {
    const double infinity = std::numeric_limits<double>::infinity();
    CHECK(lobe.reference(1.0, infinity) == 1.0);
    CHECK(lobe.reference(0.999, infinity) == 0.0);
    CHECK(lobe.reference(0.0, 1e308) == 0.0);
    CHECK(lobe.reference(0.5, 3.0) == 0.125);
    CHECK(lobe.reference(0.5, 8.0) == 0.00390625);
    CHECK(lobe.reference(-0.5, 8.0) == 0.0);
    CHECK(lobe.reference(2.0, 50.0) == 1.0);
}

/// At every input of p8, and on 2^11 cosines and the last 65 of the other formats at hard n: `fits(trace, format)`, at
/// most 1, and no fall when c grows. Formats have a name, that of p8 first.
template <class Formats, class Fits>
void check_words(const Lobe& lobe, const Formats& formats, Fits fits) {
    for (const auto& format : formats) {
        const Profile profile = parse_profile(format.name);
        const auto model = lobe.golden(profile);
        const bool all = profile.name == "p8";
        const int step = all ? 1 : std::max(1, profile.one() >> 11);
        std::vector<int> exponents{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 15, 16, 31, 32, 33, 50, 512, 1022, 1023};
        if (all) {
            exponents.clear();
            for (int n = 1; n <= max_n; ++n) exponents.push_back(n);
        }
        for (const int n : exponents) {
            std::uint32_t last = 0;
            const auto next = [&](int C) {
                if (!fits(model->trace(n, C), format)) FAIL(format.name << " n " << n << " C " << C);
                const std::uint32_t y = model->eval(n, C);
                if (y < last || y > 1U << profile.O) FAIL(format.name << " n " << n << " C " << C);
                last = y;
            };
            for (int C = 0; C < profile.one(); C += step) next(C);
            for (int C = profile.one() - std::min(step - 1, 64); C <= profile.one(); ++C) next(C);
        }
    }
}

}  // namespace glint
