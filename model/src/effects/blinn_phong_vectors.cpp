// The effect `blinn_phong_vectors`: docs/effects/blinn_phong_vectors.md.

#include <algorithm>
#include <cmath>

#include "../lobes/exp_log.hpp"
#include "effect.hpp"
#include "two_vectors.hpp"

namespace glint {
namespace {

struct BlinnPhongVectorsFormat {
    int W = 0;               ///< bits of a component
    exp_log::Log2 log2_p{};  ///< of p 4^j at L fraction bits
    exp_log::Log2 log2_s{};  ///< of s 16^j at L + 2
    exp_log::Exp2 exp2{};

    struct Steps {
        std::int64_t cp = 0, cs = 0, up = 0, us = 0, w = 0, t = 0, y = 0;
    };

    // p 4^j is below 2^(2W), s 16^j below 2^(4W); L + 2 <= 33. w is at most 62 2^L, n w below 2^(L + 16) <= 2^47. Where
    // a vector is 0, all is 0.
    Steps steps(const VectorProduct& v, std::int64_t n) const {
        Steps x;
        if (v.s_up == 0) return x;
        const int L = log2_p.L;
        x.cp = static_cast<std::int64_t>(at(static_cast<Wide>(std::max<std::int64_t>(0, v.p_up)), L - 2 * W));
        x.cs = static_cast<std::int64_t>(at(v.s_up, L + 2 - 4 * W));
        x.up = log2_p.steps(x.cp).u;
        x.us = log2_s.steps(x.cs).u;
        x.w = std::max<std::int64_t>(0, 2 * x.up - x.us);
        x.t = rnd(n * x.w, L + 1 - exp2.S);
        x.y = v.p < 0 ? 0 : exp2.steps(x.t).y;
        return x;
    }

    static Wide at(Wide value, int places) { return places >= 0 ? value << places : value >> -places; }
};

BlinnPhongVectorsFormat blinn_phong_vectors_format(const Profile& profile) {
    constexpr std::string_view name = "blinn_phong_vectors";
    const int O = profile.O;
    std::vector<int> numbers{profile.F, 16, O / 4 + 4, O + 15, O / 4, O + 4, O};
    if (!profile.shipped()) {
        check_custom(profile, name, "F,W,T,L,E,S,O");
        numbers = profile.custom;
    }
    const int L = in_range(name, "L", numbers[3], 16, 31);
    const int S = in_range(name, "S", numbers[5], O + 1, L);
    return {in_range(name, "W", numbers[1], 8, 18), exp_log::make_log2(name, L, numbers[2], L, 1),
            exp_log::make_log2(name, L + 2, numbers[2], L, 3), exp_log::make_exp2(name, numbers[4], S, O)};
}

class BlinnPhongVectors final : public EffectModel {
public:
    explicit BlinnPhongVectors(const Profile& profile)
        : BlinnPhongVectors(profile, blinn_phong_vectors_format(profile)) {}
    const BlinnPhongVectorsFormat& format() const { return f_; }

private:
    BlinnPhongVectors(const Profile& profile, const BlinnPhongVectorsFormat& f)
        : EffectModel("blinn_phong_vectors", profile, vector_ports(f.W), {term_port("y", profile, 0)}), f_(f) {}

    bool correct(std::int64_t* in) const override { return correct_vectors(in); }

    void value(const std::int64_t* in, std::int64_t* out) const override {
        out[0] = f_.steps(VectorProduct(f_.W, in, in + 3), in[6]).y;
    }

    std::vector<Intermediate> intermediates(const std::int64_t* in) const override {
        const VectorProduct v(f_.W, in, in + 3);
        const BlinnPhongVectorsFormat::Steps x = f_.steps(v, in[6]);
        const int bits = 2 * f_.W - 2, L = f_.log2_p.L;
        return after_inputs(in, {{"p", v.p, bits},
                                 {"aa", v.aa, bits},
                                 {"bb", v.bb, bits},
                                 {"j", v.j, 0},
                                 {"cp", x.cp, L},
                                 {"cs", x.cs, L + 2},
                                 {"up", x.up, L},
                                 {"us", x.us, L},
                                 {"w", x.w, L},
                                 {"t", x.t, f_.exp2.S},
                                 {"y", x.y, f_.exp2.O}});
    }

    void real(const double* in, double* out) const override {
        const double c = vectors_cosine(in);
        out[0] = c < 0 ? 0.0 : reference::blinn_phong(c, in[6]);
    }

    BlinnPhongVectorsFormat f_;
};

std::vector<GeneratedFile> emit_blinn_phong_vectors(const Profile& profile, std::string_view) {
    const BlinnPhongVectors model(profile);
    const BlinnPhongVectorsFormat& f = model.format();
    const auto text = [](int value) { return std::to_string(value); };
    const std::vector<Table> tables{f.log2_p.table("log2_p"), f.log2_s.table("log2_s"), f.exp2.table()};
    return with_tables({effect_wrapper(model,
                                       {{block::stream(), block::vectors(), block::log2(), block::step(),
                                         block::rounded(), block::exp2()},
                                        {"glint_delay"}},
                                       {{"W", text(f.W), ""},
                                        {"T", text(f.log2_p.T), ""},
                                        {"L", text(f.log2_p.L), ""},
                                        {"E", text(f.exp2.E), ""},
                                        {"S", text(f.exp2.S), ""},
                                        {"O", text(f.exp2.O), ""}},
                                       tables, {{"MULTIPLIER_STAGES", "1", "1 .. 4", "clocks of a product"}})},
                       tables);
}

std::vector<EffectCase> blinn_phong_vectors_cases(const EffectModel& model) {
    std::vector<EffectCase> cases = vectors_cases(model);
    const std::int64_t high = model.inputs()[0].high, half = (high + 1) / 2;
    cases.push_back({"c is 2^-1", {high, 0, 0, half, half, 0, 2}, "nearly a power of 2 in both logarithms"});
    cases.push_back({"the least c above 0", {high, high, 0, high, 1 - high, 0, 1}, "up has its most zeros"});
    return cases;
}

}  // namespace

Effect blinn_phong_vectors_effect() {
    return {"blinn_phong_vectors",    "c^n of the cosine of two vectors", "Blinn", make_model<BlinnPhongVectors>,
            emit_blinn_phong_vectors, blinn_phong_vectors_cases,          1.0};
}

}  // namespace glint
