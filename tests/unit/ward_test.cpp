// The effect `ward`: docs/effects/ward.md.
#include "glint/ward.hpp"

#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <string>

#include "../../model/src/lobes/exp_log.hpp"
#include "catch.hpp"
#include "glint/effect.hpp"
#include "glint/error.hpp"
#include "glint/vectors.hpp"

using namespace glint;

namespace {

using Values = std::vector<std::int64_t>;

enum Port { nl, nv, nh, ht, hb, kx, ky, log_peak };

std::unique_ptr<EffectModel> model_at(const Profile& profile) { return find_effect("ward").golden(profile, ""); }

double uniform(Random& random) { return static_cast<double>(random.next() >> 11) * 0x1p-53; }

/// A material between the ends of the roughness, half of them isotropic; a half vector near N more often than not;
/// lights and viewers of any angle, every third time down to 1 ulp.
Values random_material(const EffectModel& model, Random& random) {
    const auto alpha = [&] { return std::pow(ward_least_alpha, uniform(random)); };
    const double alpha_x = alpha(), alpha_y = random.next() % 2 == 0 ? alpha_x : alpha();
    const WardParameters p = ward_parameters(alpha_x, alpha_y);
    const double angle = std::exp2(-8 * uniform(random)) * std::numbers::pi / 2;
    const double azimuth = 2 * std::numbers::pi * uniform(random);
    std::array<double, 8> x{uniform(random),
                            uniform(random),
                            std::cos(angle),
                            std::sin(angle) * std::cos(azimuth),
                            std::sin(angle) * std::sin(azimuth),
                            p.kx,
                            p.ky,
                            p.log_peak};
    if (random.next() % 3 == 0) {
        x[nl] *= std::exp2(-model.profile().F * uniform(random));
        x[nv] *= std::exp2(-model.profile().F * uniform(random));
    }
    Values in;
    for (std::size_t port = 0; port < x.size(); ++port) in.push_back(model.inputs()[port].code(x[port]));
    return in;
}

/// The error of docs/effects/ward.md: relative above 1.
double error_of(const EffectModel& model, const Values& in) {
    std::vector<double> arguments;
    for (std::size_t p = 0; p < in.size(); ++p) arguments.push_back(model.inputs()[p].real(in[p]));
    return std::abs(static_cast<double>(model.eval_port(in).values[0]) -
                    std::ldexp(model.reference(arguments)[0], model.profile().O)) /
           model.bound_scale(arguments);
}

/// The bound of docs/effects/ward.md.
double bound(const Profile& profile) {
    const int O = profile.O, F = profile.F, H = O + 3, S = O + 4, L = F + 1;
    const exp_log::Log2 log2 = exp_log::make_log2("ward", F, std::max(4, O / 4 + 1), L);
    const exp_log::Exp2 exp2 = exp_log::make_exp2("ward", std::max(2, O / 4), S, O + 8);
    double Du = 0;
    for (std::int64_t C = 1; C <= profile.one(); ++C) {
        Du = std::max(Du, std::abs(std::ldexp(static_cast<double>(log2.steps(C).u), -L) -
                                   (F - std::log2(static_cast<double>(C)))));
    }
    double R = 0;
    for (std::int64_t f = 0; f < std::int64_t{1} << S; ++f) {
        const double real = std::exp2(S - std::ldexp(static_cast<double>(f), -S));
        R = std::max(R, std::abs(static_cast<double>(exp2.steps(f).p) - real) / real);
    }
    const double r = std::sqrt(8 + 0.5 * F);
    const double D = 2 * std::numbers::sqrt2 * r * std::ldexp(1.0, -H - 1) + std::ldexp(1.0, -2 * H - 1) +
                     std::ldexp(1.0, -S - 1) + std::ldexp(1.0, -S) + Du + std::ldexp(1.0, -S - 1);
    return 0.5 + std::ldexp(std::exp2(D) * (1 + R) - 1, O);
}

}  // namespace

TEST_CASE("ward: parameters") {
    const WardParameters p = ward_parameters(0.2, 0.5);
    CHECK(p.kx == Approx(1.6986436 / 0.2));
    CHECK(p.ky == Approx(1.6986436 / 0.5));
    CHECK(std::exp2(p.log_peak) == Approx(1 / (4 * std::numbers::pi * 0.1)));
    CHECK(std::exp2(ward_parameters(0.02, 0.02).log_peak) < 200);
    for (const double alpha : {0.0199, 0.0, -0.1, 1.01, std::nan("")}) {
        CHECK_THROWS_AS(ward_parameters(alpha, 0.5), Error);
        CHECK_THROWS_AS(ward_parameters(0.5, alpha), Error);
    }
    // What the ports carry is what was asked for, at both ends.
    for (const Profile& profile : shipped_profiles()) {
        const auto model = model_at(profile);
        for (const double alpha : {ward_least_alpha, 1.0}) {
            const WardParameters q = ward_parameters(alpha, alpha);
            for (const auto& [port, x] : {std::pair{kx, q.kx}, {ky, q.ky}, {log_peak, q.log_peak}}) {
                const EffectPort& at = model->inputs()[port];
                CHECK(std::abs(at.real(at.code(x)) - x) <= std::ldexp(0.5, -at.fraction_bits));
            }
        }
    }
}

TEST_CASE("ward: the real function is Ward's") {
    const auto model = model_at(parse_profile("p12"));
    Random random(1);
    double worst = 0;
    for (int i = 0; i < 100000; ++i) {
        const double ax = 0.02 + 0.98 * uniform(random), ay = 0.02 + 0.98 * uniform(random);
        const WardParameters p = ward_parameters(ax, ay);
        const std::array<double, 8> x{uniform(random) + 1e-6,
                                      uniform(random) + 1e-6,
                                      uniform(random),
                                      uniform(random) / 4,
                                      uniform(random) / 4 - 0.25,
                                      p.kx,
                                      p.ky,
                                      p.log_peak};
        if (x[nl] > 1 || x[nv] > 1) continue;
        const double exponent = -2 * (std::pow(x[ht] / ax, 2) + std::pow(x[hb] / ay, 2)) / (1 + x[nh]);
        const double wanted = x[nl] * std::exp(exponent) / (4 * std::numbers::pi * ax * ay * std::sqrt(x[nl] * x[nv]));
        const double found = model->reference(x)[0];
        worst = std::max(worst, std::abs(found - std::min(wanted, 256 - 0x1p-12)) / std::max(wanted, 1.0));
    }
    CHECK(worst < 1e-12);
    CHECK(worst > 0);
}

TEST_CASE("ward: exact values") {
    const auto model = model_at(parse_profile("p12"));
    const std::int64_t one = 262144, S = 65536;
    const auto y = [&](const Values& in) { return model->eval_port(in).values[0]; };
    CHECK(y({one, one, one, 0, 0, 9999, 9999, 0}) == 4096);               // the peak is 1
    CHECK(y({one, one / 4, one, 0, 0, 9999, 9999, 3 * S}) == 16 * 4096);  // 8 sqrt(4)
    CHECK(y({one / 4, one, one, 0, 0, 9999, 9999, 0}) == 2048);
    CHECK(y({one, one, one, one / 2, 0, 2 * 4096, 0, 0}) == 2896);  // 2^-(1/2)
    CHECK(y({one, one, 0, 0, -one / 2, 0, 2 * 4096, 0}) == 2048);   // 2^-1
    CHECK(y({one, one, one, 0, 0, 0, 0, 8 * S}) == (1 << 20) - 1);  // 256 is just too much
    CHECK(y({one, one, one, 0, 0, 0, 0, 8 * S - 1}) < (1 << 20) - 1);
    CHECK(y({one, 1, one, 0, 0, 0, 0, 0}) == (1 << 20) - 1);  // 512
    CHECK(y({1, one, one, 0, 0, 0, 0, 0}) == 8);              // 1/512
    CHECK(y({one, one, one, one, one, 524287, 524287, 8 * S}) == 0);
    for (const Values& dark :
         {Values{0, one, one, 0, 0, 0, 0, 0}, Values{one, 0, one, 0, 0, 0, 0, 0}, Values{-1, one, one, 0, 0, 0, 0, 0},
          Values{one, -one, one, 0, 0, 0, 0, 0}, Values{one, one, -1, 0, 0, 0, 0, 0}}) {
        CHECK(y(dark) == 0);
    }
}

TEST_CASE("ward: the bound, and the worst error over materials, are those of the document") {
    std::ifstream file(GLINT_SOURCE_DIR "/docs/effects/ward.md");
    std::ostringstream document;
    document << file.rdbuf();
    for (const Profile& profile : shipped_profiles()) {
        const auto model = model_at(profile);
        Random random(3);
        double worst = 0;
        for (int i = 0; i < 1000000; ++i) worst = std::max(worst, error_of(*model, random_material(*model, random)));
        const double limit = bound(profile);
        const auto up = [](double x) { return std::ceil(x * 1e4) / 1e4; };
        char row[100];
        std::snprintf(row, sizeof row, " | %.4f | %.4f |\n", up(worst), up(limit));
        CAPTURE(profile.name, row);
        CHECK(worst < limit);
        CHECK(limit <= find_effect("ward").bound_ulp);
        CHECK(document.str().find(row) != std::string::npos);
    }
}

TEST_CASE("ward: intermediates within their ranges, monotone, the same for L and V that change places") {
    for (const Profile& profile : shipped_profiles()) {
        const auto model = model_at(profile);
        const int O = profile.O, F = profile.F, H = O + 3, S = O + 4;
        Random random(4);
        std::uint64_t outside = 0, wrong_way = 0, asymmetric = 0;
        for (int i = 0; i < 100000; ++i) {
            Values in = random_material(*model, random);
            if (i % 2 == 0) in[kx] = random.between(0, model->inputs()[kx].high);
            std::map<std::string, std::int64_t> x;
            for (const Intermediate& value : model->trace(in)) x[std::string(value.name)] = value.code;
            const auto below = [](std::int64_t value, std::int64_t integer, int bits) {
                return value >= 0 && value < integer << bits;
            };
            outside += !below(x["hx"], 16, H) || !below(x["hy"], 16, H) || !below(x["r2"], 128, S) ||
                       x["t"] > x["r2"] || x["e"] < -(std::int64_t{F} << S) / 2 ||
                       x["e"] > std::int64_t{144} * (1 << S) + (F << S) / 2;
            // N.L and the peak make it brighter, all else darker; a step of 16 codes shows rounding nowhere.
            for (const auto& [port, sign] : {std::pair{nl, 1}, {nv, -1}, {kx, -1}, {ky, -1}, {log_peak, 1}}) {
                Values more = in;
                more[port] = std::min(more[port] + 16, model->inputs()[port].high);
                const std::int64_t y = model->eval_port(more).values[0];
                if (in[nl] > 0 && in[nv] > 0) wrong_way += sign > 0 ? y < x["y"] : y > x["y"];
            }
            // y nv = y' nl, each result within its error.
            const Values back{in[nv], in[nl], in[nh], in[ht], in[hb], in[kx], in[ky], in[log_peak]};
            const double there = model->outputs()[0].real(x["y"]);
            const double here = model->outputs()[0].real(model->eval_port(back).values[0]);
            const double light = model->inputs()[nl].real(in[nl]), viewer = model->inputs()[nv].real(in[nv]);
            if (std::max(there, here) < 255) {
                const double allowed =
                    std::ldexp(1.3, -O) * (std::max(1.0, there) * viewer + std::max(1.0, here) * light);
                asymmetric += std::abs(there * viewer - here * light) > allowed * 1.01;
            }
        }
        CAPTURE(profile.name);
        CHECK(outside == 0);
        CHECK(wrong_way == 0);
        CHECK(asymmetric == 0);
    }
}

TEST_CASE("ward: profiles without room for its guard bits are refused") {
    CHECK_NOTHROW(model_at(parse_profile("8,5")));
    CHECK_THROWS_AS(model_at(parse_profile("8,6")), Error);
    CHECK_NOTHROW(model_at(parse_profile("30,20")));
    CHECK_THROWS_AS(model_at(parse_profile("30,21")), Error);
}
