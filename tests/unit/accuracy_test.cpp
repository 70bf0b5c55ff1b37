#include "glint/accuracy.hpp"

#include <cmath>
#include <cstring>

#include "catch.hpp"
#include "glint/error.hpp"
#include "glint/lobes.hpp"
#include "glint/reference.hpp"
#include "glint/sweep.hpp"

using namespace glint;

namespace {

/// The definitions of docs/contract.md, section "Errors", one input at a time, in long double.
Accuracy plain_accuracy(const GoldenModel& model, Range n_range, Range codes) {
    const int F = model.profile().F;
    const long double ulp = std::ldexp(1.0L, -model.profile().O);
    Accuracy out;
    for (std::int64_t i = 0; i < n_range.size(); ++i) {
        const auto n = static_cast<int>(n_range[i]);
        for (std::int64_t j = 0; j < codes.size(); ++j) {
            const auto code = static_cast<std::int32_t>(codes[j]);
            const long double c = std::ldexp(static_cast<long double>(code), -F);
            const long double y = static_cast<long double>(model.eval(n, code)) * ulp;
            const long double s = c / (n - n * c + c);
            const long double f = std::fmax(0.0L, ((-1.631L * s + 2.995L) * s - 0.374L) * s + 0.002737L);
            const long double rounding = std::abs(y - f) / ulp;
            const long double error = std::abs(y - std::pow(c, static_cast<long double>(n)));
            const long double half = std::ldexp(0.5L, -F);
            const long double low = std::pow(std::fmax(0.0L, c - half), static_cast<long double>(n));
            const long double high = std::pow(std::fmin(1.0L, c + half), static_cast<long double>(n));
            ++out.inputs;
            out.rounding.merge({static_cast<double>(rounding), n, code});
            out.rounding_squares += static_cast<double>(rounding * rounding);
            out.approximation.merge({static_cast<double>(error), n, code});
            out.approximation_squares += static_cast<double>(error * error);
            out.approximation_exact.merge(
                {static_cast<double>(std::fmax(std::abs(y - low), std::abs(y - high))), n, code});
            // In the epicentre zone: tan^2(theta) <= 1 / (n - 1).
            if (n >= 2 && (1 - c * c) * (n - 1) <= c * c) {
                out.epicentre.merge({static_cast<double>(error / std::pow(c, static_cast<long double>(n))), n, code});
            }
        }
    }
    return out;
}

void check_same(const Worst& got, const Worst& want, double margin) {
    CHECK(got.value == Approx(want.value).margin(margin));
    CHECK(got.n == want.n);
    CHECK(got.cos_code == want.cos_code);
}

}  // namespace

TEST_CASE("sweeps measure what the contract defines") {
    struct Case {
        const char* profile;
        Range n, codes;
    };
    // Steps in n below and above 16 take the two ways to c^n; blocks of 4096 codes are crossed.
    for (const Case& c : {Case{"p8", {1, 40, 1}, {0, 65536, 7}}, Case{"p8", {1, 1023, 73}, {0, 65536, 11}},
                          Case{"p12", {990, 1023, 1}, {255000, 262144, 1}}, Case{"p12", {50, 50, 1}, {0, 262144, 1}},
                          Case{"p16", {2, 1000, 499}, {1000000, 1048576, 3}}, Case{"p16", {1, 3, 1}, {0, 3, 1}}}) {
        CAPTURE(c.profile, c.n.first, c.codes.first);
        const auto model = find_lobe("bps").golden(parse_profile(c.profile));
        const Accuracy want = plain_accuracy(*model, c.n, c.codes);
        const SweepResult got = sweep(*model, c.n, c.codes);
        CHECK(got.rows.size() == static_cast<std::size_t>(c.n.size()));
        CHECK(got.total.inputs == want.inputs);
        check_same(got.total.rounding, want.rounding, 1e-9);
        check_same(got.total.approximation, want.approximation, 1e-12);
        check_same(got.total.approximation_exact, want.approximation_exact, 1e-12);
        check_same(got.total.epicentre, want.epicentre, 1e-11);
        CHECK(got.total.rounding_rms() == Approx(want.rounding_rms()).epsilon(1e-9));
        CHECK(got.total.approximation_rms() == Approx(want.approximation_rms()).epsilon(1e-9));
    }
}

TEST_CASE("rows add up to the total") {
    const auto model = find_lobe("bps").golden(parse_profile("p8"));
    const SweepResult all = sweep(*model, {1, 1023, 100}, {0, 65536, 1});
    Accuracy total;
    for (const AccuracyRow& row : all.rows) {
        const SweepResult alone = sweep(*model, {row.n, row.n, 1}, {0, 65536, 1});
        check_same(row.accuracy.approximation, alone.total.approximation, 1e-12);
        total.merge(row.accuracy);
    }
    CHECK(total.inputs == all.total.inputs);
    CHECK(total.rounding.value == all.total.rounding.value);
}

TEST_CASE("threads do not change a bit of the result") {
    const auto model = find_lobe("bps").golden(parse_profile("p8"));
    const SweepResult one = sweep(*model, {1, 64, 1}, {0, 65536, 1}, 1);
    const SweepResult three = sweep(*model, {1, 64, 1}, {0, 65536, 1}, 3);
    CHECK(std::memcmp(&one.total, &three.total, sizeof one.total) == 0);
}

TEST_CASE("of equal worst cases the least n, then the least code, is named") {
    Worst worst;
    CHECK_FALSE(worst.seen());
    worst.merge({1.0, 5, 7});
    worst.merge({1.0, 5, 6});
    worst.merge({1.0, 4, 9});
    worst.merge({0.5, 1, 1});
    CHECK(worst.n == 4);
    CHECK(worst.cos_code == 9);
    CHECK(worst.seen());
}

TEST_CASE("a sweep of nothing is refused") {
    const auto model = find_lobe("bps").golden(parse_profile("p8"));
    CHECK_THROWS_AS(sweep(*model, {5, 4, 1}, {0, 10, 1}), Error);
    CHECK_THROWS_AS(sweep(*model, {1, 4, 1}, {10, 0, 1}), Error);
}

TEST_CASE("rounding error under 1 ulp at every legal input of the shipped profiles") {
    std::uint64_t inputs = 0;
    for (const Profile& profile : shipped_profiles()) {
        const auto model = find_lobe("bps").golden(profile);
        const SweepResult result = sweep(*model, {1, max_n, 1}, {0, profile.one(), 1});
        CAPTURE(profile.name, result.total.rounding.n, result.total.rounding.cos_code);
        CHECK(result.total.rounding.value < 1.0);
        CHECK(result.total.rounding.value > 0.5);  // no rounding to the nearest can be better than it everywhere
        inputs += result.total.inputs;
    }
    CHECK(inputs == 1023ULL * ((1 << 16) + (1 << 18) + (1 << 20) + 3));
}
