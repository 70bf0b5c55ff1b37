// The effect `bps_vectors`: docs/effects/bps_vectors.md.

#include <algorithm>

#include "../lobes/bps.hpp"
#include "effect.hpp"
#include "glint/reference.hpp"
#include "two_vectors.hpp"

namespace glint {
namespace {

struct BpsVectorsFormat {
    static constexpr int cut = 7;  ///< bits that x and n (r - x) lose before the division

    int W = 0;  ///< bits of a component
    int R = 0;  ///< bits of the root
    BpsPolynomial polynomial;

    struct Steps : BpsPolynomial::Steps {
        std::int64_t r = 0, x = 0, C = 0;
    };

    // x <= r < 2^R <= 2^30; n (r - x) is below 2^40, C 2^S below 2^53. Where a vector is 0, all is 0.
    Steps steps(const VectorProduct& v, std::int64_t n) const {
        Steps s;
        if (v.s_up == 0) return s;
        s.r = v.root(W, R);
        const std::int64_t p = std::max<std::int64_t>(0, v.p_up);
        s.x = R >= 2 * W ? p << (R - 2 * W) : p >> (2 * W - R);
        s.C = s.x >> cut;
        s.D = s.C + ((n * (s.r - s.x)) >> cut);
        s.quotient = (s.C << polynomial.S) / s.D;
        polynomial.horner(s);
        if (v.p < 0) s.y = 0;
        return s;
    }
};

BpsVectorsFormat bps_vectors_format(const Profile& profile) {
    constexpr std::string_view name = "bps_vectors";
    const int O = profile.O;
    if (profile.shipped()) return {16, O + 14, bps_polynomial(name, profile, O + 3, O + 3)};
    check_custom(profile, name, "F,W,R,S,K,O");
    const std::vector<int>& numbers = profile.custom;
    return {in_range(name, "W", numbers[1], 8, 18), in_range(name, "R", numbers[2], 16, 30),
            bps_polynomial(name, profile, numbers[3], numbers[4])};
}

class BpsVectors final : public EffectModel {
public:
    explicit BpsVectors(const Profile& profile) : BpsVectors(profile, bps_vectors_format(profile)) {}
    const BpsVectorsFormat& format() const { return f_; }

private:
    BpsVectors(const Profile& profile, const BpsVectorsFormat& f)
        : EffectModel("bps_vectors", profile, vector_ports(f.W), {term_port("y", profile, 0)}), f_(f) {}

    bool correct(std::int64_t* in) const override { return correct_vectors(in); }

    void value(const std::int64_t* in, std::int64_t* out) const override {
        out[0] = f_.steps(VectorProduct(f_.W, in, in + 3), in[6]).y;
    }

    std::vector<Intermediate> intermediates(const std::int64_t* in) const override {
        const VectorProduct v(f_.W, in, in + 3);
        const BpsVectorsFormat::Steps s = f_.steps(v, in[6]);
        const int bits = 2 * f_.W - 2, U = f_.R - BpsVectorsFormat::cut;
        const BpsPolynomial& p = f_.polynomial;
        return after_inputs(in, {{"p", v.p, bits},
                                 {"aa", v.aa, bits},
                                 {"bb", v.bb, bits},
                                 {"j", v.j, 0},
                                 {"r", s.r, f_.R},
                                 {"x", s.x, f_.R},
                                 {"C", s.C, U},
                                 {"D", s.D, U},
                                 {"quotient", s.quotient, p.S},
                                 {"h1", s.h1, p.K},
                                 {"h2", s.h2, p.K},
                                 {"y", s.y, p.O}});
    }

    void real(const double* in, double* out) const override {
        const double c = vectors_cosine(in);
        out[0] = c < 0 ? 0.0 : std::max(0.0, reference::bps_horner(c, in[6]));
    }

    BpsVectorsFormat f_;
};

std::vector<GeneratedFile> emit_bps_vectors(const Profile& profile, std::string_view) {
    const BpsVectors model(profile);
    const auto& [W, R, p] = model.format();
    const auto literal = [&p = p](std::int64_t value) { return verilog_literal(value, p.K + 3); };
    const auto text = [](std::int64_t value) { return std::to_string(value); };
    return {effect_wrapper(model,
                           {{block::stream(), block::vectors(), block::sqrt(R), block::step(), block::rounded(),
                             block::divider(p.S + 1), block::horner(3)}},
                           {{"W", text(W), ""},
                            {"R", text(R), ""},
                            {"S", text(p.S), ""},
                            {"K", text(p.K), ""},
                            {"O", text(p.O), ""},
                            {"A", literal(p.a), ""},
                            {"B", literal(p.b), ""},
                            {"C1", literal(p.c1), ""},
                            {"D0", literal(p.d0), ""}},
                           {}, {{"MULTIPLIER_STAGES", "1", "1 .. 4", "clocks of a product"}})};
}

}  // namespace

Effect bps_vectors_effect() {
    return {"bps_vectors",
            "bps of the cosine of two vectors",
            "this project",
            make_model<BpsVectors>,
            emit_bps_vectors,
            vectors_cases,
            1.0};
}

}  // namespace glint
