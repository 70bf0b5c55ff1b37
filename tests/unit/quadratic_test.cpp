#include <algorithm>
#include <cmath>
#include <string>

#include "glint/error.hpp"
#include "glint/fixed_point.hpp"
#include "lobe_checks.hpp"

using namespace glint;

namespace {

struct Format {
    int F, S, K, O;
    std::int64_t slope;
};

/// The contract again, with the values that the Verilog and the kernel hold on the way.
struct Plain {
    std::int64_t scaled, product_d, offset_line, line, w, sum, y;
};

Plain plain(const Format& f, int n, std::int64_t C) {
    Plain x{};
    const int cut = f.F + f.K - f.S;
    const std::int64_t one = std::int64_t{1} << (f.F + f.K);
    const std::int64_t half = (std::int64_t{1} << cut) >> 1;
    x.scaled = f.slope * n;
    x.product_d = x.scaled * ((std::int64_t{1} << f.F) - C);
    x.offset_line = one + half - x.product_d;
    x.line = std::max<std::int64_t>(0, one - x.product_d);
    x.w = (x.line + half) >> cut;
    x.sum = C * x.w + (std::int64_t{1} << (f.F + f.S - f.O - 1));
    x.y = x.sum >> (f.F + f.S - f.O);
    return x;
}

/// The widths that rtl/lobes/glint_quadratic.v and hls/lobes/glint_quadratic.hpp declare.
bool fits(const Format& f, const Plain& x) {
    const std::int64_t end = std::int64_t{1} << (f.F + f.K + 10);  // of the signed word of the line
    return unsigned_bits(f.slope, f.K) && unsigned_bits(x.scaled, f.K + 10) &&
           unsigned_bits(x.product_d, f.F + f.K + 10) && x.offset_line >= -end && x.offset_line < end &&
           unsigned_bits(x.w, f.S + 1) && x.w <= std::int64_t{1} << f.S && unsigned_bits(x.sum, f.F + f.S + 1) &&
           unsigned_bits(x.y, f.O + 1) && x.y <= std::int64_t{1} << f.O;
}

Format format(const Profile& profile) {
    Format f{profile.F, profile.O + 1, profile.O + 2, profile.O, 0};
    if (!profile.shipped()) {
        f.S = profile.custom[1];
        f.K = profile.custom[2];
    }
    f.slope = quantize_constant(0.786, f.K);
    return f;
}

}  // namespace

TEST_CASE("quadratic: the contract and its widths at every input of p8, monotone, 1 at c = 1, 0 in the tail") {
    const Profile profile = parse_profile("p8");
    const Format f = format(profile);
    CHECK(f.slope == 805);
    const auto model = find_lobe("quadratic").golden(profile);
    std::int64_t zeros = 0;
    for (int n = 1; n <= max_n; ++n) {
        std::uint32_t last = 0;
        for (int C = 0; C <= profile.one(); ++C) {
            const std::uint32_t y = model->eval(n, C);
            const Plain x = plain(f, n, C);
            if (y != x.y || y < last || !fits(f, x)) FAIL("n " << n << " C " << C);
            if (x.line == 0) {
                ++zeros;
                if (y != 0) FAIL("n " << n << " C " << C << ": the line is 0, the result " << y);
                if (n == 1) FAIL("C " << C << ": n = 1 is cut");
            }
            last = y;
        }
        if (last != 1U << profile.O) FAIL("n " << n << ": y " << last << " at c = 1");
        if (model->eval(n, 0) != 0) FAIL("n " << n << " at c = 0");
    }
    CHECK(zeros > 0);
}

TEST_CASE("quadratic: every intermediate is the contract's, corners of many formats") {
    for (const std::string name :
         {"p8", "p12", "p16", "8,4,4,4", "8,30,30,28", "22,30,30,28", "30,22,22,22", "30,30,22,4", "18,12,13,12"}) {
        CAPTURE(name);
        const Profile profile = parse_profile(name);
        const Format f = format(profile);
        const auto model = find_lobe("quadratic").golden(profile);
        const std::int64_t one = profile.one();
        for (int n = 1; n <= max_n; ++n) {
            const std::int64_t cut = one - (one << f.K) / (f.slope * n);  // the first cosine that is not cut
            for (std::int64_t C : {std::int64_t{0}, std::int64_t{1}, cut - 1, cut, cut + 1, one / 2, one - 1, one}) {
                C = std::clamp<std::int64_t>(C, 0, one);
                const Plain x = plain(f, n, C);
                const auto trace = model->trace(n, C);
                const bool same = fits(f, x) && trace.size() == 5 && trace[0].code == C && trace[1].code == x.scaled &&
                                  trace[2].code == x.line && trace[3].code == x.w && trace[4].code == x.y &&
                                  model->eval(n, C) == x.y;
                if (!same) FAIL("n " << n << " C " << C);
            }
            if (model->eval(n, static_cast<std::int64_t>(one)) != 1U << profile.O) FAIL("n " << n << " at c = 1");
        }
    }
    SUCCEED();
}

TEST_CASE("quadratic: profiles that are not legal") {
    const Lobe& lobe = find_lobe("quadratic");
    for (const char* name : {"18,12", "18,13,12", "18,11,14,12", "18,13,11,12", "18,31,14,12", "18,13,31,12",
                             "30,23,23,23", "23,30,30,28", "8,13,4,4", "18,13,14,14,12"}) {
        CAPTURE(name);
        CHECK_THROWS_AS(lobe.golden(parse_profile(name)), Error);
        CHECK_THROWS_AS(lobe.emit(parse_profile(name), default_architecture(lobe)), Error);
    }
    for (const char* name : {"8,12,4,4", "30,30,22,22", "22,30,30,28"}) {
        CAPTURE(name);
        CHECK_NOTHROW(lobe.golden(parse_profile(name)));
    }
}
