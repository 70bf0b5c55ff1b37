#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "glint/error.hpp"
#include "glint/fixed_point.hpp"
#include "glint/lanes.hpp"
#include "glint/reference.hpp"
#include "glint/vectors.hpp"
#include "lobe_checks.hpp"

using namespace glint;

namespace {

/// The contract again, in 128 bits and with a floor that is spelt out: slow and plain.
using Wide = __int128;

Wide floor_div(Wide x, Wide y) {
    const Wide q = x / y;
    return x % y != 0 && (x < 0) != (y < 0) ? q - 1 : q;
}
Wide wide_rnd(Wide x, int k) { return floor_div(x + ((Wide{1} << k) >> 1), Wide{1} << k); }

/// The word lengths, and the published constants at K fraction bits.
struct Format {
    int F, S, K, O;
    std::int64_t a = constant(reference::bps_constants.a), b = constant(reference::bps_constants.b),
                 c1 = constant(reference::bps_constants.c1), d0 = constant(reference::bps_constants.d0);
    std::int64_t constant(double published) const { return quantize_constant(published, K); }
};

Format format_of(const Profile& profile) {
    const auto numbers = profile.shipped() ? find_lobe("bps").numbers(profile.F, profile.O) : profile.custom;
    return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

struct Plain {
    Wide D, quotient, h1, h2, y;
};

Plain plain(const Format& f, int n, std::int64_t C) {
    Plain x{};
    x.D = n * (Wide{1} << f.F) - (n - 1) * Wide{C};
    x.quotient = floor_div(Wide{C} << f.S, x.D);
    x.h1 = f.b + wide_rnd(f.a * x.quotient, f.S);
    x.h2 = f.c1 + wide_rnd(x.h1 * x.quotient, f.S);
    x.y = std::max<Wide>(0, wide_rnd(x.h2 * x.quotient + (Wide{f.d0} << f.S), f.S + f.K - f.O));
    return x;
}

const std::vector<std::string> formats{"p8",          "p12",       "p16",         "8,4,7,4",     "30,30,30,28",
                                       "18,14,14,12", "16,30,9,8", "30,12,30,12", "20,26,26,20", "24,27,27,24"};

}  // namespace

TEST_CASE("every intermediate is the contract's") {
    for (const std::string& name : formats) {
        const Profile profile = parse_profile(name);
        const Format f = format_of(profile);
        const auto model = find_lobe("bps").golden(profile);
        for (const TestVector& v : make_vectors(*model, 20000, 7)) {
            if (v.n == 0 || v.cos_code < 0 || v.cos_code > profile.one()) continue;
            const Plain want = plain(f, v.n, v.cos_code);
            const auto trace = model->trace(v.n, v.cos_code);
            const bool same = value(trace, "D") == want.D && value(trace, "quotient") == want.quotient &&
                              value(trace, "h1") == want.h1 && value(trace, "h2") == want.h2 &&
                              value(trace, "y") == want.y && model->eval(v.n, v.cos_code) == want.y;
            if (!same) FAIL(name << " n " << v.n << " cos code " << v.cos_code);
        }
    }
    SUCCEED();
}

TEST_CASE("hard inputs by name") {
    for (const std::string name : {"p8", "p12", "p16"}) {
        CAPTURE(name);
        const Profile profile = parse_profile(name);
        const Format f = format_of(profile);
        const auto model = find_lobe("bps").golden(profile);
        const int one = profile.one();
        const auto top = [&](double c, int n) { return std::ldexp(reference::bps_horner(c, n), f.O); };

        SECTION("n = 1: the divisor is 2^F whatever the cosine " + name) {
            for (const int C : {0, 1, one / 3, one - 1, one}) {
                CHECK(value(model->trace(1, C), "D") == one);
                CHECK(value(model->trace(1, C), "quotient") == (static_cast<std::int64_t>(C) << f.S) >> f.F);
            }
        }
        SECTION("n = 1023: the widest divisor " + name) {
            CHECK(value(model->trace(1023, 0), "D") == 1023 * static_cast<std::int64_t>(one));
            CHECK(value(model->trace(1023, one), "D") == one);
            CHECK(value(model->trace(1023, one), "quotient") == std::int64_t{1} << f.S);
        }
        SECTION("c = 0: the floor d0, not 0 " + name) {
            for (const int n : {1, 2, 50, 1000, 1023}) {
                CHECK(value(model->trace(n, 0), "quotient") == 0);
                CHECK(model->eval(n, 0) == static_cast<std::uint32_t>(rnd(f.d0, f.K - f.O)));
            }
        }
        SECTION("c = 1: the peak is 0.9927, not 1 " + name) {
            const std::int64_t peak = rnd(f.a + f.b + f.c1 + f.d0, f.K - f.O);
            CHECK(std::abs(static_cast<double>(peak) - 0.992737 * std::ldexp(1.0, f.O)) < 1.0);
            for (const int n : {1, 2, 50, 1000, 1023}) CHECK(model->eval(n, one) == static_cast<std::uint32_t>(peak));
        }
        SECTION("c = 1 ulp and 1 - 1 ulp " + name) {
            for (const int n : {1, 2, 50, 1000, 1023}) {
                for (const int C : {1, one - 1}) {
                    const double c = std::ldexp(C, -f.F);
                    CHECK(std::abs(model->eval(n, C) - top(c, n)) < 1.0);
                }
            }
        }
        SECTION("sign changes of the polynomial: the cut to 0 starts and ends within an ulp " + name) {
            // The polynomial is below 0 for s in (0.0078, 0.1263); results there are 0, and next to it below 1 ulp.
            for (const int n : {1, 2, 50, 1000, 1023}) {
                for (const double s : {0.00780379, 0.12633238}) {
                    const auto near = std::llround(n * s / (1 + (n - 1) * s) * one);
                    for (std::int64_t C = std::max<std::int64_t>(0, near - 64); C <= near + 64; ++C) {
                        const double c = std::ldexp(static_cast<double>(C), -f.F);
                        if (!(std::abs(model->eval(n, C) - top(c, n)) < 1.0)) FAIL("n " << n << " C " << C);
                    }
                }
                const double middle = n * 0.066 / (1 + (n - 1) * 0.066);
                CHECK(model->eval(n, std::llround(middle * one)) == 0);
            }
        }
    }
}

TEST_CASE("the largest intermediates of each profile fit the widths that the Verilog declares") {
    for (const std::string& name : formats) {
        CAPTURE(name);
        const Profile profile = parse_profile(name);
        const Format f = format_of(profile);
        std::map<std::string, std::pair<Wide, Wide>> range;
        const auto note = [&](const char* what, Wide x) {
            auto& r = range.try_emplace(what, x, x).first->second;
            r = {std::min(r.first, x), std::max(r.second, x)};
        };
        // Every quotient where that is at most 2^20; else a stride that meets both ends.
        const std::int64_t last = std::int64_t{1} << f.S;
        const std::int64_t step = std::max<std::int64_t>(1, last >> 20);
        for (std::int64_t q = 0; q <= last; q += step) {
            const Wide aq = Wide{f.a} * q;
            const Wide h1 = f.b + wide_rnd(aq, f.S);
            const Wide h2 = f.c1 + wide_rnd(h1 * q, f.S);
            const Wide sum = h2 * q + (Wide{f.d0} << f.S);
            note("product 1", aq + (Wide{f.b} << f.S) + (Wide{1} << (f.S - 1)));
            note("a q", aq);
            note("h1", h1);
            note("h1 q", h1 * q);
            note("product 2", h1 * q + (Wide{f.c1} << f.S) + (Wide{1} << (f.S - 1)));
            note("h2", h2);
            note("product 3", h2 * q);
            note("sum 3", sum + (Wide{1} << (f.S + f.K - f.O - 1)));
            note("y", wide_rnd(sum, f.S + f.K - f.O));
        }
        const auto fits = [&](const char* what, int bits) {
            const Wide limit = Wide{1} << (bits - 1);
            return range.at(what).first >= -limit && range.at(what).second < limit;
        };
        CHECK(fits("a q", f.K + 3 + f.S));
        CHECK(fits("product 1", f.K + 3 + f.S));
        CHECK(fits("h1", f.K + 3));
        CHECK(fits("h1 q", f.K + 3 + f.S));
        CHECK(fits("product 2", f.K + 3 + f.S));
        CHECK(fits("h2", f.K + 2));
        CHECK(fits("product 3", f.K + 2 + f.S));
        CHECK(fits("sum 3", f.K + 2 + f.S));
        CHECK(range.at("y").second <= Wide{1} << f.O);
        CHECK(fits("a q", 63));
        CHECK(fits("product 2", 63));
    }
}

TEST_CASE("a custom format whose result could exceed 1 is refused, by the exact maximum") {
    // By brute force over every quotient, for all S up to 12 at the small K where it can happen.
    int refused = 0;
    for (int O = 4; O <= 7; ++O) {
        for (int K = O; K <= 9; ++K) {
            for (int S = O; S <= 12; ++S) {
                const Format f{16, S, K, O};
                Wide most = 0;
                for (Wide q = 0; q <= Wide{1} << S; ++q) {
                    const Wide h1 = f.b + wide_rnd(f.a * q, S);
                    const Wide h2 = f.c1 + wide_rnd(h1 * q, S);
                    most = std::max(most, wide_rnd(h2 * q + (Wide{f.d0} << S), S + K - O));
                }
                const bool above = most > Wide{1} << O;
                bool threw = false;
                try {
                    find_lobe("bps").golden(
                        parse_profile("16," + std::to_string(S) + "," + std::to_string(K) + "," + std::to_string(O)));
                } catch (const Error&) {
                    threw = true;
                }
                if (threw != above) FAIL("S " << S << " K " << K << " O " << O);
                refused += threw ? 1 : 0;
            }
        }
    }
    CHECK(refused > 0);
}

TEST_CASE("monotone in c wherever the real function rises, falling where it falls") {
    for (const std::string name : {"p8", "p12", "p16"}) {
        CAPTURE(name);
        const Profile profile = parse_profile(name);
        const auto model = find_lobe("bps").golden(profile);
        // y depends on the quotient alone, and that rises with c: at n = 1 and F >= S every quotient occurs.
        const double minimum = 0.06599512;
        std::uint32_t last = model->eval(1, 0);
        for (int C = 1; C <= profile.one(); ++C) {
            const std::uint32_t y = model->eval(1, C);
            const double s = std::ldexp(C, -profile.F);
            if (s < minimum ? y > last : y < last) FAIL("C " << C);
            last = y;
        }
        // And directly at other n.
        for (const int n : {2, 8, 50, 1000, 1023}) {
            last = 0;
            const auto first = static_cast<int>(n * minimum / (1 + (n - 1) * minimum) * profile.one()) + 1;
            for (int C = first; C <= profile.one(); ++C) {
                const std::uint32_t y = model->eval(n, C);
                if (y < last) FAIL("n " << n << " C " << C);
                last = y;
            }
        }
    }
}

TEST_CASE("eval refuses what is not legal, eval_port corrects it") {
    const auto model = find_lobe("bps").golden(parse_profile("p8"));
    const int one = 1 << 16;
    CHECK_THROWS_AS(model->eval(0, 0), Error);
    CHECK_THROWS_AS(model->eval(1024, 0), Error);
    CHECK_THROWS_AS(model->eval(1, -1), Error);
    CHECK_THROWS_AS(model->eval(1, one + 1), Error);
    CHECK_THROWS_AS(model->eval_port(-1, 0), Error);
    CHECK_THROWS_AS(model->eval_port(1024, 0), Error);
    CHECK_THROWS_AS(model->eval_port(1, 2 * one), Error);
    CHECK_THROWS_AS(model->eval_port(1, -2 * one - 1), Error);
    CHECK(model->eval_port(0, 1234) == PortResult{model->eval(1, 1234), true});
    CHECK(model->eval_port(50, one + 1) == PortResult{model->eval(50, one), true});
    CHECK(model->eval_port(50, 2 * one - 1) == PortResult{model->eval(50, one), true});
    CHECK(model->eval_port(50, -1) == PortResult{0, true});
    CHECK(model->eval_port(0, -2 * one) == PortResult{0, true});
    CHECK(model->eval_port(50, 0) == PortResult{model->eval(50, 0), false});
    CHECK(model->eval_port(50, one) == PortResult{model->eval(50, one), false});
    // The lobe's own cut to 0 is no correction.
    CHECK(model->eval_port(1, static_cast<int>(0.066 * one)) == PortResult{0, false});
}

TEST_CASE("batch gives the bits of the scalar form") {
    for (const std::string& name : formats) {
        CAPTURE(name);
        const auto model = find_lobe("bps").golden(parse_profile(name));
        const std::int64_t one = model->profile().one();
        Random random(99);
        // Odd lengths, so that the remainders of the lanes are met.
        for (const std::size_t length : {0U, 1U, 7U, 8U, 9U, 1023U, 100003U}) {
            std::vector<std::uint16_t> n;
            std::vector<std::int32_t> cos_code;
            for (std::size_t i = 0; i < length; ++i) {
                n.push_back(static_cast<std::uint16_t>(random.between(0, max_n)));
                const bool any = random.between(0, 3) == 0;
                cos_code.push_back(
                    static_cast<std::int32_t>(any ? random.between(-2 * one, 2 * one - 1) : random.between(0, one)));
            }
            for (const Lanes lanes : lanes_here()) {
                CAPTURE(lanes_name(lanes));
                use_lanes(lanes);
                std::vector<std::uint32_t> packed(length, 0xdeadbeef);
                const bool corrected = model->eval_port_batch(n, cos_code, packed);
                bool expected = false;
                for (std::size_t i = 0; i < length; ++i) {
                    const PortResult result = model->eval_port(n[i], cos_code[i]);
                    if (packed[i] != pack(result)) FAIL("n " << n[i] << " code " << cos_code[i]);
                    expected = expected || result.clamped;
                }
                CHECK(corrected == expected);
            }
        }
        std::vector<std::uint16_t> two(2);
        std::vector<std::int32_t> one_code(1);
        std::vector<std::uint32_t> packed(2);
        CHECK_THROWS_AS(model->eval_port_batch(two, one_code, packed), Error);
    }
}

TEST_CASE("batch equals scalar at every legal input of p8") {
    const auto model = find_lobe("bps").golden(parse_profile("p8"));
    const int one = model->profile().one();
    std::vector<std::int32_t> codes;
    for (int C = 0; C <= one; ++C) codes.push_back(C);
    std::vector<std::uint32_t> packed(codes.size());
    std::vector<std::uint32_t> scalar(codes.size());
    for (int n = 1; n <= max_n; ++n) {
        const std::vector<std::uint16_t> exponents(codes.size(), static_cast<std::uint16_t>(n));
        for (int C = 0; C <= one; ++C) scalar[static_cast<std::size_t>(C)] = model->eval(n, C);
        for (const Lanes lanes : lanes_here()) {
            use_lanes(lanes);
            const bool corrected = model->eval_port_batch(exponents, codes, packed);
            if (corrected || packed != scalar) FAIL("n " << n << ", lanes " << lanes_name(lanes));
        }
    }
    CHECK_THROWS_AS(use_lanes(static_cast<Lanes>(99)), Error);
}
