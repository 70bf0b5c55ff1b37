#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "catch.hpp"
#include "glint/lobes.hpp"

using namespace glint;

TEST_CASE("cubic: c^n itself for n up to 3, 1 at c = 1, 0 in the cut, falling but for an ulp") {
    for (const std::string name : {"p8", "p12"}) {
        const auto model = find_lobe("cubic").golden(parse_profile(name));
        const int one = model->profile().one();
        const double ulp = std::ldexp(1.0, -model->profile().O);
        for (int n = 1; n <= 3; ++n) {
            for (int C = 0; C <= one; ++C) {
                if (!(std::abs(model->eval(n, C) * ulp - std::pow(std::ldexp(C, -model->profile().F), n)) < ulp)) {
                    FAIL(name << " n " << n << " C " << C);
                }
            }
        }
        for (int n = 1; n <= max_n; n += name == "p8" ? 1 : 31) {
            // Where the curve is flat, the rounding of h1 may lift a result by an ulp; it never lifts it by two.
            std::uint32_t last = model->eval(n, one);
            if (last != 1U << model->profile().O) FAIL(name << " n " << n << " is not 1 at c = 1");
            for (int C = one - 1; C >= 0; --C) {
                const std::uint32_t y = model->eval(n, C);
                if (y > last + 1) FAIL(name << " n " << n << " C " << C << " rises away from the peak");
                last = std::min(last, y);
            }
            if (n > 1 && last != 0) FAIL(name << " n " << n << " is not 0 at c = 0");
        }
    }
    SUCCEED();
}

TEST_CASE("cubic: every intermediate is within the range that the document gives, at every input of p8 and p12") {
    const std::map<std::string, std::pair<double, double>> ranges{{"C", {0.0, 1.0}},     {"X", {0.0, 1.0}},
                                                                  {"T", {0.0, 3.0}},     {"h2", {0.0, 0.34}},
                                                                  {"h1", {-1.34, 0.17}}, {"y", {0.0, 1.0}}};
    for (const std::string profile : {"p8", "p12"}) {
        const auto model = find_lobe("cubic").golden(parse_profile(profile));
        for (int n = 1; n <= max_n; ++n) {
            bool cut = false;  // in the cut all but C and X stay as they are at its first input
            for (int C = model->profile().one(); C >= 0 && !cut; --C) {
                std::int64_t T = 0;
                for (const Intermediate& i : model->trace(n, C)) {
                    const auto& [low, high] = ranges.at(std::string(i.name));
                    const double value = std::ldexp(static_cast<double>(i.code), -i.fraction_bits);
                    if (value < low || value > high) FAIL(i.name << " = " << value << " at n " << n << " C " << C);
                    if (i.name == "T") T = i.code;
                }
                cut = n > 3 && T == 0 && C < model->profile().one() - 16;
            }
            if (n > 3 && !cut) FAIL("n " << n << " has no cut");
        }
    }
    SUCCEED();
}
