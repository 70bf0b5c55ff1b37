// The effect `lobe_select`: docs/effects/lobe_select.md. A lobe of the registry, chosen for each input.

#include <algorithm>

#include "effect.hpp"
#include "glint/lobe_unit.hpp"
#include "glint/lobes.hpp"

namespace glint {
namespace {

constexpr int number_bits = 4;  ///< of the port `select`

class LobeSelect final : public EffectModel {
public:
    LobeSelect(const Profile& profile, std::vector<std::unique_ptr<GoldenModel>> models)
        : EffectModel("lobe_select", profile, ports(profile, static_cast<int>(models.size())),
                      {term_port("y", profile, 0)}),
          models_(std::move(models)) {
        for (const auto& model : models_) units_.push_back(lobe_unit(*model));
    }

private:
    static std::vector<EffectPort> ports(const Profile& profile, int count) {
        EffectPort cosine = dot_port("cosine", profile);
        cosine.low = 0;
        return {{"select", EffectPort::Kind::parameter, number_bits, false, 0, 0, count - 1}, exponent_port(), cosine};
    }

    const EffectModel& unit(std::int64_t lobe) const { return *units_[static_cast<std::size_t>(lobe)]; }

    // A lobe corrects n and the cosine by its own rule.
    bool correct(std::int64_t* in) const override {
        const std::int64_t lobe = std::min(in[0], inputs()[0].high);
        const bool above = lobe != in[0];
        in[0] = lobe;
        return unit(lobe).eval_port(std::span(in + 1, 2)).clamped || above;
    }

    void value(const std::int64_t* in, std::int64_t* out) const override {
        out[0] = unit(in[0]).eval_port(std::span(in + 1, 2)).values[0];
    }

    std::vector<Intermediate> intermediates(const std::int64_t* in) const override {
        return unit(in[0]).trace(std::span(in + 1, 2));
    }

    void real(const double* in, double* out) const override {
        const auto lobe = static_cast<std::int64_t>(std::clamp(in[0], 0.0, static_cast<double>(inputs()[0].high)));
        out[0] = unit(lobe).reference(std::span(in + 1, 2))[0];
    }
    /// `real` has to see that a cosine is negative.
    bool corrects_itself() const override { return true; }

    double scale(const double* in) const override {
        const double lobe = std::clamp(in[0], 0.0, static_cast<double>(inputs()[0].high));
        return lobes()[static_cast<std::size_t>(lobe)].bound_ulp;
    }

    std::vector<std::unique_ptr<GoldenModel>> models_;
    std::vector<std::unique_ptr<EffectModel>> units_;
};

/// All lobes have the words of a shipped profile in common; of a custom one each has numbers of its own.
void check_profile(const Profile& profile) {
    if (!profile.shipped()) {
        throw Error(
            fmt::format("profile {} is not legal for the effect lobe_select: p8, p12 or p16", profile.argument()));
    }
}

std::unique_ptr<EffectModel> make_lobe_select(const Profile& profile, std::string_view) {
    check_profile(profile);
    std::vector<std::unique_ptr<GoldenModel>> models;
    for (const Lobe& lobe : lobes()) models.push_back(lobe.golden(profile));
    return std::make_unique<LobeSelect>(profile, std::move(models));
}

std::vector<GeneratedFile> emit_lobe_select(const Profile& profile, std::string_view) {
    const auto model = make_lobe_select(profile, "");
    const std::size_t count = lobes().size();
    const int O = profile.O;
    std::string slots, clocks;
    std::vector<GeneratedFile> parts;
    int slowest = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const Lobe& lobe = lobes()[k];
        for (GeneratedFile& part : lobe.emit(profile, default_architecture(lobe))) parts.push_back(std::move(part));
    }
    for (std::size_t k = 0; k < count; ++k) {
        const std::string module = fmt::format("glint_{}_{}", lobes()[k].name, profile.name);
        const auto part = std::find_if(parts.begin(), parts.end(), [&](const GeneratedFile& file) {
            return file.unit && file.unit->name == module;
        });
        const int latency = part->unit->architectures[0].latency;
        slowest = std::max(slowest, latency);
        clocks = fmt::format("8'd{}{}{}", latency, clocks.empty() ? "" : ", ", clocks);
        slots += fmt::format(R"(        if (MASK[{k}]) begin : {lobe}
            wire ready, tag;
            {module} #(
                .TAG_W(1)
            ) unit (
                .clk_i(clk_i),
                .rst_ni(rst_ni),
                .valid_i(start[{k}]),
                .ready_o(ready),
                .n_i(n_i),
                .cos_i(cosine_i),
                .tag_i(1'b0),
                .valid_o(unit_valid[{k}]),
                .ready_i(1'b1),
                .y_o(unit_y[{top}:{low}]),
                .tag_o(tag),
                .clamped_o(unit_clamped[{k}])
            );
            wire unused = &{{1'b0, ready, tag}};
        end else begin : no_{lobe}
            assign unit_valid[{k}] = 1'b0;
            assign unit_clamped[{k}] = 1'b0;
            assign unit_y[{top}:{low}] = {W}'d0;
            wire unused = &{{1'b0, start[{k}]}};
        end
)",
                             fmt::arg("k", k), fmt::arg("lobe", lobes()[k].name), fmt::arg("module", module),
                             fmt::arg("W", O + 1), fmt::arg("top", (O + 1) * static_cast<int>(k + 1) - 1),
                             fmt::arg("low", (O + 1) * static_cast<int>(k)));
    }
    const std::int64_t all = (std::int64_t{1} << count) - 1;
    GeneratedFile file = effect_module(
        *model, "", {}, "glint_effect_lobe_select",
        fmt::format(R"(    wire unused_ports = &{{1'b0, n_i, cosine_i}};  // where MASK is 0

    wire [{last}:0] start, unit_valid, unit_clamped;
    wire [{y_last}:0] unit_y;

    glint_effect_lobe_select #(
        .O        ({O}),
        .N        ({count}),
        .MASK     (MASK),
        .CLOCKS   ({{{clocks}}}),
        .LOG_DEPTH(LOG_DEPTH),
        .TAG_W    (TAG_W)
    ) select (
        .clk_i         (clk_i),
        .rst_ni        (rst_ni),
        .valid_i       (valid_i),
        .ready_o       (ready_o),
        .select_i      (select_i),
        .tag_i         (tag_i),
        .valid_o       (valid_o),
        .ready_i       (ready_i),
        .y_o           (y_o),
        .tag_o         (tag_o),
        .clamped_o     (clamped_o),
        .start_o       (start),
        .unit_valid_i  (unit_valid),
        .unit_clamped_i(unit_clamped),
        .unit_y_i      (unit_y)
    );

    generate
{slots}    endgenerate
)",
                    fmt::arg("last", count - 1), fmt::arg("y_last", static_cast<int>(count) * (O + 1) - 1),
                    fmt::arg("O", O), fmt::arg("count", count), fmt::arg("clocks", clocks), fmt::arg("slots", slots)));
    const std::string tag = "    parameter TAG_W = 16\n";
    file.text.replace(
        file.text.find(tag), tag.size(),
        fmt::format("    parameter TAG_W = 16,\n    parameter [{}:0] MASK = {}'d{},  // what is built: bit "
                    "k the lobe k\n    parameter LOG_DEPTH = 6  // inputs in flight: 2^LOG_DEPTH\n",
                    count - 1, count, all));
    file.unit->numbers = {
        {"O", std::to_string(O)}, {"N", std::to_string(count)}, {"CLOCKS", fmt::format("{{{}}}", clocks)}};
    file.unit->parameters.push_back({"MASK", std::to_string(all), fmt::format("0 to {}", all),
                                     "what is built: bit k the lobe k", static_cast<int>(count)});
    file.unit->parameters.push_back({"LOG_DEPTH", "6", "1 to 16", "2^LOG_DEPTH inputs are in flight at most"});
    return made_of(std::move(file), std::move(parts), {"default", {}, slowest + block::lobe_select().clocks, 1});
}

std::vector<EffectCase> lobe_select_cases(const EffectModel& model) {
    std::vector<EffectCase> out = common_effect_cases(model);
    const std::int64_t one = model.profile().one();
    for (std::size_t k = 0; k < lobes().size(); ++k) {
        const auto lobe = static_cast<std::int64_t>(k);
        const std::string of(lobes()[k].name);
        out.push_back({of, {lobe, 50, one - one / 64}, "another lobe's number, or its clocks"});
        out.push_back({of + ", peak", {lobe, 1023, one}, "another lobe's number, or its clocks"});
        out.push_back({of + ", cosine = -1 ulp", {lobe, 50, -1}, "corrected by the lobe"});
    }
    out.push_back({"above the last lobe", {(1 << number_bits) - 1, 50, one}, "corrected: the last lobe"});
    return out;
}

}  // namespace

Effect lobe_select_effect() {
    return {"lobe_select",
            "the lobe of that number",
            "this project",
            make_lobe_select,
            emit_lobe_select,
            lobe_select_cases,
            1.0};
}

}  // namespace glint
