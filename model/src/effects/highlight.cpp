#include "highlight.hpp"

#include <algorithm>

namespace glint {
namespace {

class Highlight final : public EffectModel {
public:
    Highlight(std::string_view effect, std::string_view cosine, const Profile& profile,
              std::unique_ptr<GoldenModel> lobe)
        : EffectModel(effect, profile, {exponent_port(), dot_port(cosine, profile), dot_port("nl", profile)},
                      {term_port("y", profile, 0)}),
          lobe_(std::move(lobe)) {}

private:
    // The lobe's port semantics make the result 0 where the cosine is negative; n and cosines above 1 are corrected
    // already.
    void value(const std::int64_t* in, std::int64_t* out) const override {
        out[0] = in[2] > 0 ? lobe_->eval_port(static_cast<int>(in[0]), in[1]).y : 0;
    }

    std::vector<Intermediate> intermediates(const std::int64_t* in) const override {
        std::vector<Intermediate> values{{"nl", in[2], profile().F}};
        for (const Intermediate& x : lobe_->trace(static_cast<int>(in[0]), in[1])) values.push_back(x);
        if (in[2] <= 0) values.back().code = 0;
        return values;
    }

    void real(const double* in, double* out) const override {
        out[0] = 0.0;
        if (in[2] > 0.0 && in[1] >= 0.0) lobe_->reference(in[0], {in + 1, 1}, {out, 1});
    }

    std::unique_ptr<GoldenModel> lobe_;
};

struct Choice {
    const Lobe* lobe = nullptr;
    Profile profile;
};

Choice choose(const Profile& profile, std::string_view lobe) {
    const LobeChoice choice = parse_lobe(lobe);
    return {choice.lobe, profile.options.empty() ? with_options(profile, choice.options) : profile};
}

}  // namespace

std::unique_ptr<EffectModel> make_highlight(std::string_view effect, std::string_view cosine, const Profile& profile,
                                            std::string_view lobe) {
    const Choice choice = choose(profile, lobe);
    return std::make_unique<Highlight>(effect, cosine, choice.profile, choice.lobe->golden(choice.profile));
}

std::vector<GeneratedFile> emit_highlight(std::string_view effect, std::string_view cosine, const Profile& profile,
                                          std::string_view lobe) {
    const Choice choice = choose(profile, lobe);
    const Profile& p = choice.profile;
    const Highlight model(effect, cosine, p, choice.lobe->golden(p));
    std::vector<GeneratedFile> parts = choice.lobe->emit(p, default_architecture(*choice.lobe));
    const HardwareUnit unit = *parts.front().unit;
    GeneratedFile file = effect_module(model, choice.lobe->name, {}, "glint_effect_highlight",
                                       fmt::format(R"(    wire [TAG_W+1:0] tag_in, tag_out;
    wire [{O}:0] y;
    wire clamped;  // what the lobe corrects; the effect has its own rule
    wire unused = &{{1'b0, clamped}};

    glint_effect_highlight #(
        .F    ({F}),
        .O    ({O}),
        .TAG_W(TAG_W)
    ) highlight (
        .n_i       (n_i),
        .cos_i     ({cosine}_i),
        .nl_i      (nl_i),
        .tag_i     (tag_i),
        .lobe_tag_o(tag_in),
        .lobe_y_i  (y),
        .lobe_tag_i(tag_out),
        .y_o       (y_o),
        .tag_o     (tag_o),
        .clamped_o (clamped_o)
    );

    glint_{lobe}_{profile} #(
        .TAG_W(TAG_W + 2)
    ) lobe (
        .clk_i    (clk_i),
        .rst_ni   (rst_ni),
        .valid_i  (valid_i),
        .ready_o  (ready_o),
        .n_i      (n_i),
        .cos_i    ({cosine}_i),
        .tag_i    (tag_in),
        .valid_o  (valid_o),
        .ready_i  (ready_i),
        .y_o      (y),
        .tag_o    (tag_out),
        .clamped_o(clamped)
    );
)",
                                                   fmt::arg("F", p.F), fmt::arg("O", p.O), fmt::arg("cosine", cosine),
                                                   fmt::arg("lobe", choice.lobe->name), fmt::arg("profile", p.name)));
    file.unit->numbers = {{"F", std::to_string(p.F)}, {"O", std::to_string(p.O)}};
    return made_of(std::move(file), std::move(parts), {"default", {}, unit.architectures[0].latency, 1});
}

std::vector<EffectCase> highlight_cases(const EffectModel& model) {
    std::vector<EffectCase> cases = common_effect_cases(model);
    const std::int64_t one = model.profile().one();
    const std::string behind = "behind the surface: 0 whatever the lobe answers";
    cases.push_back({"peak, nl = 0", {50, one, 0}, behind});
    cases.push_back({"peak, nl = -1 ulp", {50, one, -1}, behind});
    cases.push_back({"peak, nl = 1 ulp", {50, one, 1}, "in front: the whole lobe"});
    cases.push_back({"peak, nl at its least code", {50, one, -2 * one}, "corrected, and behind the surface"});
    cases.push_back({"cosine = 0, nl = 1", {50, 0, one}, "the lobe's own answer, which need not be 0"});
    cases.push_back({"cosine = -1 ulp, nl = 1", {50, -1, one}, "0, and no correction"});
    cases.push_back({"cosine below -1, nl = 1", {50, -one - 1, one}, "0, and a correction"});
    cases.push_back({"cosine above 1, nl = 0", {50, one + 1, 0}, "0, and a correction all the same"});
    cases.push_back({"n = 0, nl = 0", {0, one, 0}, "0, and a correction all the same"});
    cases.push_back({"everything out of range", {0, 2 * one - 1, 2 * one - 1}, "three corrections at once"});
    return cases;
}

}  // namespace glint
