// The effect `shade`: docs/effects/shade.md. All effects of one light's part of a pixel, in one unit.

#include <algorithm>
#include <map>
#include <mutex>

#include "effect.hpp"
#include "glint/shade.hpp"

namespace glint {
namespace {

/// The terms, in the order of their bits in the port `effects`; bit 0 is the ambient light. A further one is appended.
struct Term {
    std::string_view effect;
    bool diffuse = false;
};
constexpr Term terms[] = {
    {"lambert", true}, {"phong", false},         {"blinn_phong", false},           {"oren_nayar", true},
    {"ward", false},   {"cook_torrance", false}, {"cook_torrance_modified", false}};
constexpr std::size_t term_count = std::size(terms);

constexpr int E = 7;  ///< integer bits beyond 1.0 of the sums of terms and of the colours

/// The port of shade that feeds a port of a term: parameters of a material bear the term's name, but for the exponent.
std::string port_name(std::string_view effect, const EffectPort& port) {
    if (port.kind != EffectPort::Kind::parameter || port.name == "n") return std::string(port.name);
    return fmt::format("{}_{}", effect, port.name);
}

/// Names live as long as the program: ports hold views.
std::string_view lasting(const std::string& name) {
    static std::map<std::string, std::string> names;
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    return names.try_emplace(name, name).first->second;
}

constexpr std::string_view shade_channels[] = {"r", "g", "b"};

/// The colours, in the order of their ports.
enum Colour { ka, ia, kd, ks, i, colour_count };
constexpr std::string_view colour_names[colour_count] = {"ka", "ia", "kd", "ks", "i"};

class Shade final : public EffectModel {
public:
    Shade(const Profile& profile, std::string_view lobe, std::vector<std::unique_ptr<EffectModel>> models)
        : EffectModel("shade", profile, ports(profile, models),
                      {term_port("r", profile, E), term_port("g", profile, E), term_port("b", profile, E)}),
          lobe_(lobe),
          terms_(std::move(models)),
          ambient_(find_effect("ambient").golden(profile, lobe)),
          tint_(find_effect("tint").golden(profile, lobe)) {
        for (const auto& term : terms_) {
            std::vector<std::size_t> where;
            for (const EffectPort& port : term->inputs()) where.push_back(index(port_name(term->effect(), port)));
            feeds_.push_back(where);
        }
        for (std::size_t k = 0; k < std::size(colour_names); ++k) {
            colours_[k] = index(fmt::format("{}_r", colour_names[k]));
        }
    }

    std::string_view lobe() const { return lobe_; }
    const EffectModel& term(std::size_t t) const { return *terms_[t]; }

    /// The place of an input port.
    std::size_t index(std::string_view name) const {
        const auto found =
            std::find_if(inputs().begin(), inputs().end(), [&](const auto& p) { return p.name == name; });
        return static_cast<std::size_t>(found - inputs().begin());
    }

private:
    static std::vector<EffectPort> ports(const Profile& profile,
                                         const std::vector<std::unique_ptr<EffectModel>>& models) {
        std::vector<EffectPort> out{{"effects", EffectPort::Kind::parameter, static_cast<int>(term_count) + 1, false, 0,
                                     0, (std::int64_t{2} << term_count) - 1}};
        for (const auto& model : models) {
            for (EffectPort port : model->inputs()) {
                port.name = lasting(port_name(model->effect(), port));
                const bool there =
                    std::any_of(out.begin(), out.end(), [&](const auto& p) { return p.name == port.name; });
                if (!there) out.push_back(port);
            }
        }
        const auto colour = [&](Colour which, auto make) {
            const std::string_view name = colour_names[which];
            for (const std::string_view channel : shade_channels) {
                out.push_back(make(lasting(fmt::format("{}_{}", name, channel)), profile));
            }
        };
        colour(ka, material_colour_port);
        colour(ia, light_colour_port);
        colour(kd, material_colour_port);
        colour(ks, material_colour_port);
        colour(i, light_colour_port);
        return out;
    }

    template <class Number>
    std::vector<Number> inputs_of(std::size_t t, const Number* in) const {
        std::vector<Number> out;
        for (const std::size_t p : feeds_[t]) out.push_back(in[p]);
        return out;
    }

    template <class Number>
    std::vector<Number> colours(const Number* in, Colour k, Colour i) const {
        std::vector<Number> out;
        for (const Colour colour : {k, i}) {
            const Number* first = in + colours_[colour];
            out.insert(out.end(), first, first + 3);
        }
        return out;
    }

    template <class Number>
    std::vector<Number> tint_inputs(Number sum, const Number* in, Colour k) const {
        std::vector<Number> out = colours(in, k, i);
        out.insert(out.begin(), sum);
        return out;
    }

    struct Parts {
        EffectResult term[term_count], ambient, part[2];  // part: diffuse, specular
        std::int64_t sum[2] = {0, 0};
        bool clamped = false;
        std::int64_t total[3] = {0, 0, 0};
    };

    // Each sum of terms and the total are cut to what O + 8 bits hold; before, at most term_count 2^(O+8).
    Parts parts(const std::int64_t* in) const {
        Parts x;
        const std::int64_t most = outputs()[0].high;
        const std::int64_t asked = in[0];
        bool any[2] = {false, false};
        for (std::size_t t = 0; t < term_count; ++t) {
            if ((asked >> (t + 1) & 1) == 0) continue;
            const int kind = terms[t].diffuse ? 0 : 1;
            x.term[t] = terms_[t]->eval_port(inputs_of(t, in));
            x.sum[kind] = std::min(most, x.sum[kind] + x.term[t].values[0]);
            x.clamped |= x.term[t].clamped;
            any[kind] = true;
        }
        for (int kind = 0; kind < 2; ++kind) {
            x.part[kind] = tint_->eval_port(tint_inputs(x.sum[kind], in, kind == 0 ? kd : ks));
            x.clamped |= any[kind] && x.part[kind].clamped;
        }
        x.ambient = ambient_->eval_port(colours(in, ka, ia));
        const bool lit = (asked & 1) != 0;
        x.clamped |= lit && x.ambient.clamped;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::int64_t base = lit ? x.ambient.values[c] : 0;
            x.total[c] = std::min(most, base + x.part[0].values[c] + x.part[1].values[c]);
        }
        return x;
    }

    /// Only what is asked for is corrected, by the effect that it is for.
    bool correct(std::int64_t* in) const override { return parts(in).clamped; }

    void value(const std::int64_t* in, std::int64_t* out) const override {
        const Parts x = parts(in);
        std::copy(std::begin(x.total), std::end(x.total), out);
    }

    std::vector<Intermediate> intermediates(const std::int64_t* in) const override {
        static constexpr std::string_view names[3][3] = {{"ambient_r", "ambient_g", "ambient_b"},
                                                         {"diffuse_r", "diffuse_g", "diffuse_b"},
                                                         {"specular_r", "specular_g", "specular_b"}};
        const Parts x = parts(in);
        const int O = profile().O;
        std::vector<Intermediate> out;
        for (std::size_t t = 0; t < term_count; ++t) {
            out.push_back({terms[t].effect, x.term[t].values.empty() ? 0 : x.term[t].values[0], O});
        }
        out.push_back({"diffuse", x.sum[0], O});
        out.push_back({"specular", x.sum[1], O});
        for (std::size_t c = 0; c < 3; ++c) {
            out.push_back({names[0][c], (in[0] & 1) != 0 ? x.ambient.values[c] : 0, O});
            out.push_back({names[1][c], x.part[0].values[c], O});
            out.push_back({names[2][c], x.part[1].values[c], O});
        }
        for (std::size_t c = 0; c < 3; ++c) out.push_back({shade_channels[c], x.total[c], O});
        return out;
    }

    void real(const double* in, double* out) const override {
        const double most = outputs()[0].real(outputs()[0].high);
        const auto asked = static_cast<std::int64_t>(in[0]);
        double sum[2] = {0.0, 0.0};
        for (std::size_t t = 0; t < term_count; ++t) {
            if ((asked >> (t + 1) & 1) == 0) continue;
            double& part = sum[terms[t].diffuse ? 0 : 1];
            part = std::min(most, part + terms_[t]->reference(inputs_of(t, in))[0]);
        }
        const std::vector<double> diffuse = tint_->reference(tint_inputs(sum[0], in, kd));
        const std::vector<double> specular = tint_->reference(tint_inputs(sum[1], in, ks));
        const std::vector<double> ambient = ambient_->reference(colours(in, ka, ia));
        for (std::size_t c = 0; c < 3; ++c) {
            out[c] = std::min(most, ((asked & 1) != 0 ? ambient[c] : 0.0) + diffuse[c] + specular[c]);
        }
    }

    // A term's error is multiplied by k i; each part adds its own rounding.
    double scale(const double* in) const override {
        const auto asked = static_cast<std::int64_t>(in[0]);
        double bound = 1.5;  // ambient, diffuse, specular: half an ulp each
        for (std::size_t t = 0; t < term_count; ++t) {
            if ((asked >> (t + 1) & 1) == 0) continue;
            const std::vector<double> k_and_i = colours(in, terms[t].diffuse ? kd : ks, i);
            double most = 0.0;
            for (std::size_t c = 0; c < 3; ++c) most = std::max(most, k_and_i[c] * k_and_i[c + 3]);
            bound += find_effect(terms[t].effect).bound_ulp * terms_[t]->bound_scale(inputs_of(t, in)) * most;
        }
        return bound;
    }

    std::string lobe_;
    std::vector<std::unique_ptr<EffectModel>> terms_;
    std::unique_ptr<EffectModel> ambient_, tint_;
    std::vector<std::vector<std::size_t>> feeds_;  ///< of each term, the ports that feed its own
    std::size_t colours_[colour_count];            ///< the port of each colour's red
};

std::unique_ptr<Shade> shade_model(const Profile& profile, std::string_view lobe) {
    std::vector<std::unique_ptr<EffectModel>> models;
    for (const Term& term : terms) models.push_back(find_effect(term.effect).golden(profile, lobe));
    const Profile named = profile.options.empty() ? with_options(profile, parse_lobe(lobe).options) : profile;
    return std::make_unique<Shade>(named, lobe, std::move(models));
}

std::unique_ptr<EffectModel> make_shade(const Profile& profile, std::string_view lobe) {
    return shade_model(profile, lobe);
}

/// The unit of a term, where MASK has its bit; else it counts as ready, and nothing comes.
std::string slot(const Shade& shade, std::size_t t) {
    const EffectModel& term = shade.term(t);
    const Effect& effect = find_effect(terms[t].effect);
    const EffectPort& y = term.outputs()[0];
    const int W = shade.profile().O + 8;
    std::string connections;
    for (const EffectPort& port : term.inputs()) {
        connections += fmt::format("                .{}_i({}_i),\n", port.name, port_name(effect.name, port));
    }
    return fmt::format(
        R"(        if (MASK[{bit}]) begin : {effect}
            wire tag;
            wire [{y_top}:0] y;
            {module} #(
                .TAG_W(1)
            ) unit (
                .clk_i(clk_i),
                .rst_ni(rst_ni),
                .valid_i(start),
                .ready_o(unit_ready[{t}]),
{connections}                .tag_i(1'b0),
                .valid_o(unit_valid[{t}]),
                .ready_i(1'b1),
                .y_o(y),
                .tag_o(tag),
                .clamped_o(unit_clamped[{t}])
            );
            assign unit_y[{top}:{low}] = {padded};
            wire unused_tag = &{{1'b0, tag}};
        end else begin : no_{effect}
            assign unit_ready[{t}] = 1'b1;
            assign unit_valid[{t}] = 1'b0;
            assign unit_clamped[{t}] = 1'b0;
            assign unit_y[{top}:{low}] = {W}'d0;
            wire unused_start = &{{1'b0, start}};
        end
)",
        fmt::arg("bit", t + 1), fmt::arg("effect", effect.name), fmt::arg("y_top", y.bits - 1),
        fmt::arg("module", effect_module_name(term, effect.takes_lobe ? parse_lobe(shade.lobe()).lobe->name : "")),
        fmt::arg("t", t), fmt::arg("connections", connections), fmt::arg("top", W * static_cast<int>(t + 1) - 1),
        fmt::arg("low", W * static_cast<int>(t)),
        fmt::arg("padded", y.bits == W ? "y" : fmt::format("{{{}'d0, y}}", W - y.bits)), fmt::arg("W", W));
}

/// The default of LOG_DEPTH. One result a clock asks for 2^LOG_DEPTH from the latency of the slowest term, and 10, on:
/// of all profiles 6, but for the 2 O + 29 clocks of cook_torrance.
std::string log_depth(int O) {
    if (2 * O + 29 + 10 <= 64) return "6";
    std::size_t bit = 1;
    while (terms[bit - 1].effect != "cook_torrance") ++bit;
    return fmt::format("MASK[{}] ? 7 : 6", bit);
}

std::vector<GeneratedFile> emit_shade(const Profile& profile, std::string_view lobe) {
    const auto shade = shade_model(profile, lobe);
    std::string slots, ports;
    std::int64_t diffuse = 0;
    for (std::size_t t = 0; t < term_count; ++t) {
        slots += slot(*shade, t);
        if (terms[t].diffuse) diffuse |= std::int64_t{2} << t;
    }
    for (const EffectPort& port : shade->inputs()) ports += fmt::format(", {}_i", port.name);
    const int O = profile.O;
    GeneratedFile file = effect_module(
        *shade, parse_lobe(lobe).lobe->name, {}, "glint_effect_shade",
        fmt::format(R"(    // A unit that is not built reads nothing of its ports.
    wire unused_ports = &{{1'b0{ports}}};

    wire start;
    wire [{last}:0] unit_ready, unit_valid, unit_clamped;
    wire [{units}:0] unit_y;

    glint_effect_shade #(
        .O        ({O}),
        .N        ({N}),
        .MASK     (MASK),
        .DIFFUSE  ({bits}'d{diffuse}),
        .LOG_DEPTH(LOG_DEPTH),
        .TAG_W    (TAG_W)
    ) shade (
        .clk_i         (clk_i),
        .rst_ni        (rst_ni),
        .valid_i       (valid_i),
        .ready_o       (ready_o),
        .effects_i     (effects_i),
        .ka_i          ({{ka_b_i, ka_g_i, ka_r_i}}),
        .ia_i          ({{ia_b_i, ia_g_i, ia_r_i}}),
        .kd_i          ({{kd_b_i, kd_g_i, kd_r_i}}),
        .ks_i          ({{ks_b_i, ks_g_i, ks_r_i}}),
        .i_i           ({{i_b_i, i_g_i, i_r_i}}),
        .tag_i         (tag_i),
        .valid_o       (valid_o),
        .ready_i       (ready_i),
        .r_o           (r_o),
        .g_o           (g_o),
        .b_o           (b_o),
        .tag_o         (tag_o),
        .clamped_o     (clamped_o),
        .start_o       (start),
        .unit_ready_i  (unit_ready),
        .unit_valid_i  (unit_valid),
        .unit_clamped_i(unit_clamped),
        .unit_y_i      (unit_y)
    );

    generate
{slots}    endgenerate
)",
                    fmt::arg("ports", ports), fmt::arg("N", term_count), fmt::arg("last", term_count - 1),
                    fmt::arg("bits", term_count + 1), fmt::arg("units", static_cast<int>(term_count) * (O + 8) - 1),
                    fmt::arg("O", O), fmt::arg("diffuse", diffuse), fmt::arg("slots", slots)));
    const std::string tag = "    parameter TAG_W = 16\n";
    file.text.replace(
        file.text.find(tag), tag.size(),
        fmt::format("    parameter TAG_W = 16,\n    parameter [{}:0] MASK = {}'d{},  // what is built: a bit "
                    "each as in the port effects\n    parameter LOG_DEPTH = {}  // inputs in flight: "
                    "2^LOG_DEPTH\n",
                    term_count, term_count + 1, (std::int64_t{2} << term_count) - 1, log_depth(O)));
    file.unit->numbers = {{"O", std::to_string(O)},
                          {"N", std::to_string(term_count)},
                          {"DIFFUSE", fmt::format("{}'d{}", term_count + 1, diffuse)}};
    file.unit->parameters.push_back({"MASK", std::to_string((std::int64_t{2} << term_count) - 1),
                                     fmt::format("0 to {}", (std::int64_t{2} << term_count) - 1),
                                     "what is built: a bit each as in the port effects", term_count + 1});
    file.unit->parameters.push_back({"LOG_DEPTH", log_depth(O), "1 to 16", "2^LOG_DEPTH inputs are in flight at most"});
    // One result a clock: as many are in flight as the slowest term and what is around it take.
    std::vector<GeneratedFile> parts;
    int slowest = 0;
    for (const Term& term : terms) {
        for (GeneratedFile& part : find_effect(term.effect).emit(profile, lobe)) {
            if (part.unit) slowest = std::max(slowest, part.unit->architectures[0].latency);
            parts.push_back(std::move(part));
        }
    }
    return made_of(std::move(file), std::move(parts), {"default", {}, slowest + block::shade().clocks, 1});
}

std::vector<EffectCase> shade_cases(const EffectModel& model) {
    const auto ports = model.inputs();
    const std::int64_t one = std::int64_t{1} << model.profile().O;
    const std::int64_t all = ports[0].high;
    // A pixel in full light: everything asked for, dot products 1/2, colours 1, and parameters of which each term has a
    // value of its own, below saturation: half of their range, but for those that would make it 0 or saturate.
    const std::pair<std::string_view, std::int64_t> parameters[] = {{"cook_torrance_falloff", one},           // 1
                                                                    {"cook_torrance_level", 0},               // 2^0
                                                                    {"cook_torrance_modified_level", 0},      // 2^0
                                                                    {"cook_torrance_modified_stretch", 256},  // 1
                                                                    {"cook_torrance_modified_c0", 0}};
    std::vector<std::int64_t> base;
    for (const EffectPort& port : ports) {
        const bool colour = port.kind == EffectPort::Kind::colour;
        std::int64_t code = colour ? one : std::clamp((port.high + 1) / 2, port.low, port.high);
        for (const auto& [name, own] : parameters) {
            if (port.name == name) code = own;
        }
        base.push_back(code);
    }
    base[0] = all;
    std::vector<EffectCase> cases;
    const auto add = [&](std::string name, std::initializer_list<std::pair<std::string_view, std::int64_t>> changes,
                         std::string risk) {
        std::vector<std::int64_t> in = base;
        for (std::size_t p = 0; p < ports.size(); ++p) {
            for (const auto& [port, code] : changes) {
                if (ports[p].name == port) in[p] = code;
            }
        }
        cases.push_back({std::move(name), std::move(in), std::move(risk)});
    };
    add("everything", {}, "all parts add up");
    add("nothing asked for", {{"effects", 0}}, "0, whatever the units answer");
    add("ambient alone", {{"effects", 1}}, "the sums of terms are 0");
    for (std::size_t t = 0; t < term_count; ++t) {
        const std::string name(terms[t].effect);
        add(name + " alone", {{"effects", std::int64_t{2} << t}}, "another term's bit");
        add("all but " + name, {{"effects", all - (std::int64_t{2} << t)}}, "another term's bit");
    }
    add("behind the surface", {{"nl", -1}}, "only ambient is left");
    add("nl out of range, ambient alone", {{"effects", 1}, {"nl", ports[1].least()}},
        "what is not asked for is not corrected");
    add("nl out of range", {{"nl", 2 * model.profile().one() - 1}}, "corrected");
    add("ka above 1, not asked for", {{"effects", all - 1}, {"ka_r", 2 * one - 1}},
        "what is not asked for is not corrected");
    add("ka above 1", {{"ka_r", one + 1}}, "corrected");
    add("kd above 1, specular alone", {{"effects", 4}, {"kd_r", one + 1}}, "what is not asked for is not corrected");
    add("ks above 1, diffuse alone", {{"effects", 2}, {"ks_b", one + 1}}, "what is not asked for is not corrected");
    add("ks above 1", {{"ks_b", one + 1}}, "corrected");
    add("brightest", {{"i_r", 16 * one - 1}, {"i_g", 16 * one - 1}, {"i_b", 16 * one - 1}, {"ia_r", 16 * one - 1}},
        "sums carry into the highest bits");
    add("each channel its own", {{"kd_r", 0}, {"ks_g", 0}, {"ka_b", 0}, {"i_b", 3}}, "channels mix");
    return cases;
}

}  // namespace

std::vector<std::string_view> shade_effects() {
    std::vector<std::string_view> out{"ambient"};
    for (const Term& term : terms) out.push_back(term.effect);
    return out;
}

Effect shade_effect() {
    return {"shade",
            "ambient + tint(sum of diffuse terms) + tint(sum of specular terms)",
            "B. T. Phong 1975",
            make_shade,
            emit_shade,
            shade_cases,
            1.0,
            true};
}

}  // namespace glint
