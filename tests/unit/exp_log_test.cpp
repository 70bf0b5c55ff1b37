#include "../../model/src/lobes/exp_log.hpp"

#include <cmath>
#include <fstream>
#include <sstream>

#include "catch.hpp"
#include "glint/lobes.hpp"

using namespace glint;
using namespace glint::exp_log;

namespace {

const double ln2 = std::log(2.0);

bool fits_signed(std::int64_t x, int width) {
    return x >= -(std::int64_t{1} << (width - 1)) && x < std::int64_t{1} << (width - 1);
}

bool fits(std::int64_t x, int width) { return x >= 0 && x < std::int64_t{1} << width; }

Log2 log2_of(const Profile& profile) {
    const WordLengths x = word_lengths("blinn_phong", profile);
    return make_log2("blinn_phong", profile.F, x.T, x.L);
}

Exp2 exp2_of(const Profile& profile) {
    const WordLengths x = word_lengths("blinn_phong", profile);
    return make_exp2("blinn_phong", x.E, x.S, profile.O);
}

/// Every entry in its fields; pieces that join; the value 1 at the far end, or what the function has there.
void check_table(const Table& table, int G, std::int64_t end) {
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const auto& row = table.rows[i];
        CAPTURE(table.name, i);
        CHECK(fits(row[0], table.fields[0].width));
        CHECK(fits_signed(row[1], table.fields[1].width));
        CHECK(fits_signed(row[2], table.fields[2].width));
        const std::int64_t next = i + 1 < table.rows.size() ? table.rows[i + 1][0] : end;
        CHECK(row[1] + row[2] == (next - row[0]) << G);
    }
    CHECK(table.rows.size() >= 4);
}

/// Greatest error of p over all fractions, in units of its last place.
double exp2_error(const Exp2& exp2) {
    double worst = 0;
    for (std::int64_t f = 0; f < std::int64_t{1} << exp2.S; ++f) {
        const double real = std::exp2(exp2.S - std::ldexp(static_cast<double>(f), -exp2.S));
        worst = std::max(worst, std::abs(static_cast<double>(exp2.steps(f).p) - real));
    }
    return worst;
}

/// The greatest n 2^(-n w) over the real n of 1 .. 1023.
double greatest_slope(double w) {
    const double n = w > 0 ? std::clamp(1 / (w * ln2), 1.0, 1023.0) : 1023.0;
    return n * std::exp2(-n * w);
}

/// docs/exp-log.md, "Bounds". `slope` is the greatest Du n 2^(-n (w - Du)).
double bound(const Exp2& exp2, double p_error, double slope) {
    const double q = std::ldexp(1.0, -exp2.S - 1);
    return 0.5 + std::ldexp(p_error, exp2.O - exp2.S) + std::ldexp(std::exp2(q) * ln2 * (slope + q), exp2.O);
}

/// The row of docs/exp-log.md, and that the bound is one.
void check_row(const std::string& lobe, const Profile& profile, double first, double second, double total) {
    std::ifstream file(GLINT_SOURCE_DIR "/docs/exp-log.md");
    std::ostringstream text;
    text << file.rdbuf();
    char row[200];
    // Rounded up: they are bounds.
    const auto up = [](double x) { return std::ceil(x * 10000) / 10000; };
    std::snprintf(row, sizeof row, "| `%s` | `%s` | %.4f | %.4f | %.4f |\n", lobe.c_str(), profile.name.c_str(),
                  up(first), up(second), up(total));
    CAPTURE(row);
    CHECK(text.str().find(row) != std::string::npos);
    CHECK(total < 1);
}

std::int64_t intermediate(const GoldenModel& model, int n, std::int64_t C, std::string_view name) {
    for (const Intermediate& x : model.trace(n, C)) {
        if (x.name == name) return x.code;
    }
    FAIL("no " << name);
    return 0;
}

}  // namespace

TEST_CASE("log2: every cosine at every shipped profile: exact ends, strictly monotone, in range, within the bound") {
    for (const Profile& profile : shipped_profiles()) {
        const Log2 log2 = log2_of(profile);
        const Exp2 exp2 = exp2_of(profile);
        check_table(log2.table(), 0, std::int64_t{1} << log2.L);
        CHECK(log2.steps(0).u == std::int64_t{31} << log2.L);
        CHECK(log2.steps(profile.one()).u == 0);
        CHECK(log2.steps(profile.one() / 2).u == std::int64_t{1} << log2.L);
        CHECK(log2.steps(1).u == std::int64_t{profile.F} << log2.L);
        std::int64_t before = log2.steps(0).u;
        double worst = 0;
        double slope = 0;
        for (int C = 1; C <= profile.one(); ++C) {
            const Log2::Steps x = log2.steps(C);
            const double real = profile.F - std::log2(static_cast<double>(C));
            const double off = std::abs(std::ldexp(static_cast<double>(x.u), -log2.L) - real);
            worst = std::max(worst, off);
            slope = std::max(slope, off * greatest_slope(real - off));
            if (real < off) FAIL("u is off by more than itself at C = " << C);
            if (x.u >= before || x.u < 0 || x.u > std::int64_t{profile.F} << log2.L) FAIL("u at C = " << C);
            if (!fits(x.l, log2.L) || !fits_signed(x.h, log2.L - log2.T + 2) || x.h <= 0) FAIL("l, h at C = " << C);
            if (x.z < 0 || x.z > profile.F || !fits(x.M, profile.F - 1)) FAIL("z, M at C = " << C);
            before = x.u;
        }
        const double p_error = exp2_error(exp2);
        check_row("blinn_phong", profile, std::ldexp(worst, log2.L), p_error, bound(exp2, p_error, slope));
    }
}

TEST_CASE("exp2: every t at every shipped profile: exact at 0, never rises, in range, nothing in the tail") {
    for (const Profile& profile : shipped_profiles()) {
        const Exp2 exp2 = exp2_of(profile);
        check_table(exp2.table(), 2, std::int64_t{1} << (exp2.S - 1));
        CHECK(exp2.steps(0).p == std::int64_t{1} << exp2.S);
        CHECK(exp2.steps(0).y == std::int64_t{1} << profile.O);
        std::int64_t before = exp2.steps(0).y;
        const std::int64_t end = std::int64_t{profile.O + 4} << exp2.S;
        for (std::int64_t t = 0; t < end; ++t) {
            const Exp2::Steps x = exp2.steps(t);
            if (x.y > before || x.y < 0) FAIL("y at t = " << t);
            if (!fits(x.p, exp2.S + 1) || !fits_signed(x.h, exp2.S - exp2.E + 3) || x.h >= 0) FAIL("p, h at t = " << t);
            if (t >> exp2.S > profile.O + 1 && x.y != 0) FAIL("y in the tail at t = " << t);
            before = x.y;
        }
        CHECK(exp2.steps(std::int64_t{profile.O + 1} << exp2.S).y == 1);
        CHECK(exp2.steps((std::int64_t{profile.O + 1} << exp2.S) + 1).y <= 1);
        CHECK(exp2.steps(std::int64_t{1023 * 31} << exp2.S).y == 0);
    }
}

TEST_CASE("gauss: v at every cosine and shipped profile: exact at 1, strictly monotone, in range, within the bound") {
    for (const Profile& profile : shipped_profiles()) {
        const auto model = find_lobe("gauss").golden(profile);
        const Exp2 exp2 = exp2_of(profile);
        const int L = word_lengths("gauss", profile).L;
        std::int64_t before = -1;
        double worst = 0;
        double slope = 0;
        for (int C = profile.one(); C >= 0; --C) {
            const std::int64_t v = intermediate(*model, 1, C, "v");
            const double theta = std::acos(std::ldexp(C, -profile.F));
            const double real = theta * theta / (2 * ln2);
            const double off = std::abs(std::ldexp(static_cast<double>(v), -L) - real);
            worst = std::max(worst, off);
            slope = std::max(slope, off * greatest_slope(real - off));
            if (real < off) FAIL("v is off by more than itself at C = " << C);
            if (v <= before || !fits(v, L + 1)) FAIL("v at C = " << C);
            before = v;
        }
        CHECK(intermediate(*model, 1, profile.one(), "v") == 0);
        CHECK(std::ldexp(static_cast<double>(before), -L) < 1.78);
        const double p_error = exp2_error(exp2);
        check_row("gauss", profile, std::ldexp(worst, L), p_error, bound(exp2, p_error, slope));
    }
}

TEST_CASE("spherical_gaussian: g at every n and shipped profile: in range, within the bound") {
    for (const Profile& profile : shipped_profiles()) {
        const auto model = find_lobe("spherical_gaussian").golden(profile);
        const Exp2 exp2 = exp2_of(profile);
        double worst = 0;
        double slope = 0;
        int K = 0;
        for (const Intermediate& x : model->trace(1, 0)) K = x.name == "g" ? x.fraction_bits : K;
        REQUIRE(K > 0);
        for (int n = 1; n <= max_n; ++n) {
            const std::int64_t g = intermediate(*model, n, 0, "g");
            const double real = (n + 0.775) / ln2;
            const double off = std::abs(std::ldexp(static_cast<double>(g), -K) - real);
            worst = std::max(worst, off);
            // d 2^(-d (real - off)) is greatest at d = 1 / ((real - off) ln 2), which is below 1.
            slope = std::max(slope, off / ((real - off) * ln2 * std::exp(1.0)));
            CHECK(g < std::int64_t{1509} << K);
            CHECK((real - off) * ln2 > 1);
        }
        const double p_error = exp2_error(exp2);
        check_row("spherical_gaussian", profile, std::ldexp(worst, K), p_error, bound(exp2, p_error, slope));
    }
}

TEST_CASE("log2, exp2: no entry of any legal table lies near a half") {
    std::size_t tables = 0;
    for (int T = 4; T <= 10; ++T) {
        for (int L = std::max(9, 2 * T + 1); L <= 38; ++L, ++tables) {
            // The entries depend on T and L alone.
            CHECK_NOTHROW(make_pieces(log2_1p, T, 1, L, 0));
            const int F = std::max(8, T + 1);
            CHECK_NOTHROW(find_lobe("gauss").emit(Profile{"", F, 5, {F, T, L, 2, 6, 5}, ""},
                                                  default_architecture(find_lobe("gauss"))));
        }
    }
    for (int E = 2; E <= 8; ++E) {
        for (int S = std::max(5, 2 * E + 2); S <= 32; ++S, ++tables) CHECK_NOTHROW(make_exp2("exp2", E, S, 4));
    }
    CHECK(tables == 315);
    CHECK_THROWS_AS(nearest((Wide{1} << (wide_bits - 5)) + 1, 4), Error);  // a half and a little
}

TEST_CASE("blinn_phong, spherical_gaussian, gauss: illegal word lengths are refused") {
    const auto refused = [](const char* lobe, const char* profile) {
        CAPTURE(lobe, profile);
        CHECK_THROWS_AS(find_lobe(lobe).golden(parse_profile(profile)), Error);
        CHECK_THROWS_AS(find_lobe(lobe).emit(parse_profile(profile), default_architecture(find_lobe(lobe))), Error);
    };
    for (const char* lobe : {"blinn_phong", "gauss"}) {
        CHECK_NOTHROW(find_lobe(lobe).golden(parse_profile("18,5,25,3,16,12")));
        for (const char* profile : {"18,5,25,3,16", "18,3,25,3,16,12", "18,11,25,3,16,12", "18,5,39,3,16,12",
                                    "18,5,25,1,16,12", "18,5,25,9,20,12", "18,5,25,3,12,12", "18,5,25,3,33,12",
                                    "18,5,25,3,25,12", "18,9,18,3,16,12", "18,5,25,8,17,12"}) {
            refused(lobe, profile);
        }
    }
    refused("blinn_phong", "18,5,18,3,16,12");  // L above F, or u would not fall strictly
    refused("blinn_phong", "8,7,21,3,16,12");
    CHECK_NOTHROW(find_lobe("spherical_gaussian").golden(parse_profile("18,14,3,16,12")));
    for (const char* profile : {"18,14,3,16", "18,3,3,16,12", "18,34,3,16,12", "18,14,1,16,12", "18,14,3,12,12"}) {
        refused("spherical_gaussian", profile);
    }
}
