// The lobe `blinn_phong`: docs/lobes/blinn_phong.md.

#include "exp_log.hpp"

namespace glint {
namespace {

struct BlinnPhongFormat {
    static constexpr std::string_view lobe = "blinn_phong";
    exp_log::Log2 log2;
    exp_log::Exp2 exp2;

    struct Steps {
        std::int64_t z = 0, l = 0, u = 0, t = 0, p = 0, y = 0;
    };

    // u <= 31 2^L, so n u < 2^(L + 15) <= 2^53.
    Steps steps(int n, std::int64_t C) const {
        const exp_log::Log2::Steps a = log2.steps(C);
        const std::int64_t t = rnd(n * a.u, log2.L - exp2.S);
        const exp_log::Exp2::Steps b = exp2.steps(t);
        return {a.z, a.l, a.u, t, b.p, b.y};
    }

    std::vector<Intermediate> named(std::int64_t C, const Steps& x) const {
        return {{"C", C, log2.F},   {"z", x.z, 0},      {"l", x.l, log2.L}, {"u", x.u, log2.L},
                {"t", x.t, exp2.S}, {"p", x.p, exp2.S}, {"y", x.y, exp2.O}};
    }

    double real(double c, double n) const { return reference::blinn_phong(c, n); }
};

BlinnPhongFormat blinn_phong_format(const Profile& profile) {
    constexpr std::string_view lobe = BlinnPhongFormat::lobe;
    const exp_log::WordLengths x = exp_log::word_lengths(lobe, profile);
    return {exp_log::make_log2(lobe, profile.F, x.T, x.L), exp_log::make_exp2(lobe, x.E, x.S, profile.O)};
}

std::vector<GeneratedFile> emit_blinn_phong(const Profile& profile, const Architecture& architecture) {
    const BlinnPhongFormat f = blinn_phong_format(profile);
    const auto text = [](int value) { return std::to_string(value); };
    return generated_sources(f.lobe, profile, architecture,
                             {{block::ports(), block::log2(), block::rounded(), block::exp2()}, {"glint_delay"}},
                             {{"F", text(f.log2.F), ""},
                              {"T", text(f.log2.T), ""},
                              {"L", text(f.log2.L), ""},
                              {"E", text(f.exp2.E), ""},
                              {"S", text(f.exp2.S), ""},
                              {"O", text(f.exp2.O), ""}},
                             {{"int F", text(f.log2.F), "fraction bits of the cosine"},
                              {"int T", text(f.log2.T), "address bits of log2"},
                              {"int L", text(f.log2.L), "fraction bits of u"},
                              {"int E", text(f.exp2.E), "address bits of exp2"},
                              {"int S", text(f.exp2.S), "fraction bits of t and p"},
                              {"int O", text(f.exp2.O), "fraction bits of the output"}},
                             {f.log2.table(), f.exp2.table()});
}

std::vector<HardCase> blinn_phong_hard_cases(const GoldenModel& model) {
    std::vector<HardCase> cases = common_hard_cases(model);
    exp_log::add_end_cases(model, cases);
    const int one = model.profile().one();
    const std::vector<std::string_view> everywhere{"exhaustive", "kernel", "oracle", "log2"};
    cases.push_back(
        {"c = 1/2 - 1 ulp, n = 1", 1, one / 2 - 1, "the longest mantissa: its logarithm must not reach 1", everywhere});
    cases.push_back({"c = 1/2 + 1 ulp, n = 3", 3, one / 2 + 1, "the shortest mantissa", everywhere});
    return cases;
}

}  // namespace

Lobe blinn_phong_lobe() {
    return {"blinn_phong",
            "c^n as exp2(n log2 c)",
            "F,T,L,E,S,O",
            reference::blinn_phong,
            make_plain<blinn_phong_format>,
            emit_blinn_phong,
            blinn_phong_hard_cases,
            exp_log::shipped_numbers,
            {},
            false,
            false,
            true};
}

}  // namespace glint
