// The effect `pixel`: docs/effects/pixel.md. The dot products of vectors, then `shade`, cut to 0 .. 1.

#include <algorithm>

#include "effect.hpp"
#include "frame.hpp"
#include "glint/shade.hpp"

namespace glint {
namespace {

constexpr int W = 16;  ///< bits of a component

constexpr std::string_view channels[] = {"r", "g", "b"};
constexpr std::string_view vectors[] = {"light", "view", "normal", "tangent", "bitangent"};
constexpr std::string_view components[] = {"light_x",   "light_y",   "light_z",     "view_x",      "view_y",
                                           "view_z",    "normal_x",  "normal_y",    "normal_z",    "tangent_x",
                                           "tangent_y", "tangent_z", "bitangent_x", "bitangent_y", "bitangent_z"};

/// The dot products by the names of shade's ports.
struct Dot {
    std::string_view name;
    std::int64_t Frame::Dots::*code;
};
constexpr Dot dots[] = {{"nl", &Frame::Dots::nl}, {"nv", &Frame::Dots::nv}, {"lv", &Frame::Dots::lv},
                        {"rv", &Frame::Dots::rv}, {"nh", &Frame::Dots::nh}, {"vh", &Frame::Dots::vh},
                        {"ht", &Frame::Dots::ht}, {"hb", &Frame::Dots::hb}};

bool is_dot(const EffectPort& port) { return port.kind == EffectPort::Kind::dot; }

class Pixel final : public EffectModel {
public:
    Pixel(const Profile& profile, std::unique_ptr<EffectModel> shade)
        : EffectModel("pixel", shade->profile(), ports(*shade),
                      {result_port("r", profile), result_port("g", profile), result_port("b", profile)}),
          frame_{W, profile.F},
          shade_(std::move(shade)) {
        std::size_t own = std::size(components);  // the place of `effects` is the same
        for (const EffectPort& port : shade_->inputs()) {
            if (is_dot(port)) {
                const auto found = std::find_if(std::begin(dots), std::end(dots),
                                                [&](const Dot& dot) { return dot.name == port.name; });
                if (found == std::end(dots)) throw Error(fmt::format("pixel has no dot product {}", port.name));
                feeds_.push_back({0, found->code});
            } else {
                feeds_.push_back({feeds_.empty() ? 0 : ++own, nullptr});
            }
        }
    }

    const EffectModel& shade() const { return *shade_; }

private:
    /// What feeds a port of shade: a port of its own, or a dot product.
    struct Feed {
        std::size_t port;
        std::int64_t Frame::Dots::*dot;
    };

    static EffectPort result_port(std::string_view name, const Profile& profile) {
        EffectPort out = material_colour_port(name, profile);
        out.kind = EffectPort::Kind::term;
        return out;
    }

    static std::vector<EffectPort> ports(const EffectModel& shade) {
        std::vector<EffectPort> out{shade.inputs()[0]};
        for (const std::string_view name : components) out.push_back(component_port(name, W));
        for (const EffectPort& port : shade.inputs().subspan(1)) {
            if (!is_dot(port)) out.push_back(port);
        }
        return out;
    }

    Frame::Dots products(const std::int64_t* in) const {
        const auto vector = [&](std::size_t v) { return Frame::Vector{in[1 + 3 * v], in[2 + 3 * v], in[3 + 3 * v]}; };
        return frame_.dots(vector(0), vector(1), vector(2), vector(3), vector(4));
    }

    std::vector<std::int64_t> shade_inputs(const std::int64_t* in) const {
        const Frame::Dots x = products(in);
        std::vector<std::int64_t> out;
        for (const Feed& feed : feeds_) out.push_back(feed.dot == nullptr ? in[feed.port] : x.*feed.dot);
        return out;
    }

    EffectResult pixel(const std::int64_t* in) const {
        EffectResult out = shade_->eval_port(shade_inputs(in));
        for (std::int64_t& value : out.values) value = std::min(value, outputs()[0].high);
        return out;
    }

    /// All vectors are legal; the rest is corrected by shade, as it is asked for.
    bool correct(std::int64_t* in) const override { return pixel(in).clamped; }

    void value(const std::int64_t* in, std::int64_t* out) const override {
        const EffectResult x = pixel(in);
        std::copy(x.values.begin(), x.values.end(), out);
    }

    void batch(std::span<const std::int32_t* const> inputs, std::span<std::int32_t* const> outputs,
               std::span<std::uint8_t> clamped) const override {
        std::vector<std::int64_t> in(inputs.size());
        for (std::size_t i = 0; i < clamped.size(); ++i) {
            for (std::size_t p = 0; p < in.size(); ++p) in[p] = inputs[p][i];
            const EffectResult x = pixel(in.data());
            clamped[i] = x.clamped ? 1 : 0;
            for (std::size_t p = 0; p < x.values.size(); ++p) outputs[p][i] = static_cast<std::int32_t>(x.values[p]);
        }
    }

    std::vector<Intermediate> intermediates(const std::int64_t* in) const override {
        const Frame::Dots x = products(in);
        std::vector<Intermediate> out;
        for (const Dot& dot : dots) out.push_back({dot.name, x.*dot.code, frame_.F});
        std::vector<Intermediate> inside = shade_->trace(shade_inputs(in));
        inside.resize(inside.size() - std::size(channels));
        out.insert(out.end(), inside.begin(), inside.end());
        const EffectResult y = pixel(in);
        for (std::size_t c = 0; c < std::size(channels); ++c) out.push_back({channels[c], y.values[c], profile().O});
        return out;
    }

    /// The real function and the bound are those of shade at the dot products of the contract: the codes of the vectors
    /// are exact in a double.
    std::vector<double> real_inputs(const double* in) const {
        std::vector<std::int64_t> codes;
        for (std::size_t p = 0; p < inputs().size(); ++p) codes.push_back(inputs()[p].code(in[p]));
        const Frame::Dots x = products(codes.data());
        std::vector<double> out;
        for (std::size_t p = 0; p < feeds_.size(); ++p) {
            const Feed& feed = feeds_[p];
            out.push_back(feed.dot == nullptr ? in[feed.port] : shade_->inputs()[p].real(x.*feed.dot));
        }
        return out;
    }

    void real(const double* in, double* out) const override {
        const std::vector<double> x = shade_->reference(real_inputs(in));
        std::transform(x.begin(), x.end(), out, [](double value) { return std::min(value, 1.0); });
    }
    double scale(const double* in) const override { return shade_->bound_scale(real_inputs(in)); }

    Frame frame_;
    std::unique_ptr<EffectModel> shade_;
    std::vector<Feed> feeds_;  ///< of each port of shade
};

std::unique_ptr<Pixel> pixel_model(const Profile& profile, std::string_view lobe) {
    if (profile.F < W || profile.F > 29) {
        throw Error(fmt::format("F = {} is not legal for the effect pixel: {} to 29", profile.F, W));
    }
    return std::make_unique<Pixel>(profile, find_effect("shade").golden(profile, lobe));
}

std::unique_ptr<EffectModel> make_pixel(const Profile& profile, std::string_view lobe) {
    return pixel_model(profile, lobe);
}

/// The bits of MASK whose effects read the dot product.
std::int64_t readers(std::string_view dot, const Profile& profile, std::string_view lobe) {
    const std::vector<std::string_view> names = shade_effects();
    std::int64_t out = 0;
    for (std::size_t bit = 1; bit < names.size(); ++bit) {
        const auto model = find_effect(names[bit]).golden(profile, lobe);
        const auto inputs = model->inputs();
        if (std::any_of(inputs.begin(), inputs.end(), [&](const EffectPort& p) { return p.name == dot; })) {
            out |= std::int64_t{1} << bit;
        }
    }
    return out;
}

std::vector<GeneratedFile> emit_pixel(const Profile& profile, std::string_view lobe) {
    const auto model = pixel_model(profile, lobe);
    const EffectModel& shade = model->shade();
    std::vector<GeneratedFile> parts = find_effect("shade").emit(profile, lobe);
    const HardwareUnit& inner = *parts.front().unit;
    const int F = profile.F, O = profile.O;
    const std::size_t bits = shade_effects().size();

    // What waits for the dot products: the ports of shade that are none, the last on top.
    std::string waiting, connections;
    int wide = 0;
    for (const EffectPort& port : shade.inputs()) {
        if (is_dot(port)) {
            connections += fmt::format("        .{0}_i({0}),\n", port.name);
            continue;
        }
        connections += fmt::format("        .{}_i(waited[{}:{}]),\n", port.name, wide + port.bits - 1, wide);
        waiting = fmt::format("{}_i{}{}", port.name, waiting.empty() ? "" : ", ", waiting);
        wide += port.bits;
    }
    std::string vector_ports;
    for (const std::string_view vector : vectors) {
        vector_ports += fmt::format("        .{0}_i({{{0}_z_i, {0}_y_i, {0}_x_i}}),\n", vector);
    }
    const auto built = [&](std::string_view dot) {
        return fmt::format("(MASK & {}'d{}) != {}'d0", bits, readers(dot, profile, lobe), bits);
    };
    GeneratedFile file = effect_module(
        *model, parse_lobe(lobe).lobe->name, {}, "glint_effect_pixel",
        fmt::format(R"(    wire start, taken;
    wire [{F_top}:0] nl, nv, lv, rv, nh, vh, ht, hb;
    wire [{wide_top}:0] waited;
    wire [TAG_W-1:0] tag;
    wire [{sum_top}:0] sum;

    glint_effect_pixel #(
        .W     ({W}),
        .F     ({F}),
        .O     ({O}),
        .WIDE  ({wide}),
        .WITH_R({rv}),
        .WITH_H({nh}),
        .WITH_V({vh}),
        .WITH_T({ht}),
        .TAG_W (TAG_W)
    ) pixel (
        .clk_i(clk_i),
        .rst_ni(rst_ni),
        .valid_i(valid_i),
        .ready_o(ready_o),
{vector_ports}        .waiting_i({{{waiting}}}),
        .tag_i(tag_i),
        .start_o(start),
        .taken_i(taken),
        .nl_o(nl),
        .nv_o(nv),
        .lv_o(lv),
        .rv_o(rv),
        .nh_o(nh),
        .vh_o(vh),
        .ht_o(ht),
        .hb_o(hb),
        .waited_o(waited),
        .tag_o(tag),
        .sum_i(sum),
        .pixel_o({{b_o, g_o, r_o}})
    );

    {shade} #(
        .TAG_W(TAG_W),
        .MASK(MASK),
        .LOG_DEPTH(LOG_DEPTH)
    ) shade (
        .clk_i(clk_i),
        .rst_ni(rst_ni),
        .valid_i(start),
        .ready_o(taken),
{connections}        .tag_i(tag),
        .valid_o(valid_o),
        .ready_i(ready_i),
        .r_o(sum[{sum_r}:0]),
        .g_o(sum[{sum_g}:{sum_r1}]),
        .b_o(sum[{sum_top}:{sum_g1}]),
        .tag_o(tag_o),
        .clamped_o(clamped_o)
    );
)",
                    fmt::arg("W", W), fmt::arg("F", F), fmt::arg("O", O), fmt::arg("F_top", F + 1),
                    fmt::arg("wide", wide), fmt::arg("wide_top", wide - 1), fmt::arg("waiting", waiting),
                    fmt::arg("vector_ports", vector_ports), fmt::arg("rv", built("rv")), fmt::arg("nh", built("nh")),
                    fmt::arg("vh", built("vh")), fmt::arg("ht", built("ht")), fmt::arg("connections", connections),
                    fmt::arg("shade", inner.name), fmt::arg("sum_r", O + 7), fmt::arg("sum_r1", O + 8),
                    fmt::arg("sum_g", 2 * O + 15), fmt::arg("sum_g1", 2 * O + 16), fmt::arg("sum_top", 3 * O + 23)));
    // The choices of shade are those of the pixel.
    std::string choices;
    for (const HardwareUnit::Parameter& parameter : inner.parameters) {
        if (parameter.name == "TAG_W") continue;
        const std::string range = parameter.bits == 0 ? "" : fmt::format("[{}:0] ", parameter.bits - 1);
        const std::string size = parameter.bits == 0 ? "" : fmt::format("{}'d", parameter.bits);
        choices += fmt::format(",\n    parameter {}{} = {}{}", range, parameter.name, size, parameter.value);
        file.unit->parameters.push_back(parameter);
    }
    const std::string tag = "    parameter TAG_W = 16\n";
    file.text.replace(file.text.find(tag), tag.size(), fmt::format("    parameter TAG_W = 16{}\n", choices));
    file.unit->numbers = {
        {"W", std::to_string(W)}, {"F", std::to_string(F)}, {"O", std::to_string(O)}, {"WIDE", std::to_string(wide)}};
    const int latency = block::frame(F).clocks + inner.architectures[0].latency;
    return made_of(std::move(file), std::move(parts), {"default", {}, latency, 1});
}

std::vector<EffectCase> pixel_cases(const EffectModel& model) {
    const auto ports = model.inputs();
    const std::int64_t one = std::int64_t{1} << model.profile().O;
    const std::int64_t high = component_port("", W).high, low = -high - 1;
    const std::pair<std::string_view, std::int64_t> parameters[] = {
        {"n", 50},
        {"ward_kx", 2 * one},
        {"ward_ky", 3 * one},
        {"ward_log_peak", 0},
        {"cook_torrance_falloff", one},
        {"cook_torrance_level", 0},
        {"cook_torrance_modified_level", 0},
        {"cook_torrance_modified_stretch", 256},
        {"cook_torrance_modified_c0", 0},
    };
    // A pixel in full light, the highlight near: N = (0, 0, 1), L and V about it; colours 1/8 or 1, so that nothing is
    // cut.
    std::vector<std::int64_t> base;
    for (const EffectPort& port : ports) {
        std::int64_t code = std::clamp((port.high + 1) / 2, port.low, port.high);
        if (port.kind == EffectPort::Kind::colour) code = port.name.starts_with('i') ? one : one / 8;
        for (const auto& [name, own] : parameters) {
            if (port.name == name) code = own;
        }
        base.push_back(code);
    }
    const std::int64_t all = ports[0].high;
    base[0] = all;
    const std::int64_t frame[] = {9830, 0, 31258, -9831, 0, 31259, 0, 0, high, high, 0, 0, 0, high, 0};
    std::copy(std::begin(frame), std::end(frame), base.begin() + 1);
    using Changes = std::initializer_list<std::pair<std::string_view, std::int64_t>>;
    std::vector<EffectCase> cases;
    const auto add = [&](std::string name, Changes changes, std::string risk) {
        std::vector<std::int64_t> in = base;
        for (std::size_t p = 0; p < ports.size(); ++p) {
            for (const auto& [port, code] : changes) {
                if (ports[p].name == port) in[p] = code;
                if (std::find(std::begin(vectors), std::end(vectors), port) != std::end(vectors) &&
                    ports[p].kind == EffectPort::Kind::component && ports[p].name.starts_with(port)) {
                    in[p] = code;
                }
            }
        }
        cases.push_back({std::move(name), std::move(in), std::move(risk)});
    };
    add("everything", {}, "all parts add up, and are cut");
    const std::vector<std::string_view> names = shade_effects();
    for (std::size_t bit = 0; bit < names.size(); ++bit) {
        add(fmt::format("{} alone", names[bit]), {{"effects", std::int64_t{1} << bit}},
            "a dot product or a parameter that came too early or too late");
    }
    add("nothing asked for", {{"effects", 0}}, "0, whatever the vectors");
    add("light behind the surface", {{"light_z", -31258}}, "only ambient is left");
    add("L = -V", {{"light_x", 9831}, {"light_z", -31259}}, "H is 0: its dot products are 0, and clamped is not 1");
    add("L = V = N", {{"light_x", 0}, {"light_z", high}, {"view_x", 0}, {"view_z", high}},
        "nh = 2^F at the top of the highlight, though no vector reaches the length 1");
    add("longer than 1", {{"effects", 6}, {"light", 18919}, {"view", 18919}, {"normal", 18919}},
        "unit vectors by rounding: N.L is above 1, cut, and clamped is not 1");
    add("as long as can be", {{"light", low}, {"view", low}, {"normal", low}, {"tangent", low}, {"bitangent", low}},
        "the greatest sums and products: N.L = 3, |H| = 2 sqrt(3)");
    add("as long as can be, opposite", {{"light", low}, {"view", high}, {"normal", high}},
        "the least dot products; H is (-1, -1, -1)");
    add("the light mirrored as far as can be", {{"light", high}, {"view", low}, {"normal", high}},
        "2 (N.L)(N.V) - L.V is cut at its ends");
    add("no vectors", {{"light", 0}, {"view", 0}, {"normal", 0}, {"tangent", 0}, {"bitangent", 0}},
        "0 / 0: all dot products are 0, and clamped is not 1");
    add("no normal", {{"normal", 0}}, "nh is 0; ht and hb are not");
    add("no tangents", {{"effects", 32}, {"tangent", 0}, {"bitangent", 0}}, "ht and hb are 0, the others are not");
    add("the sum so far",
        {{"effects", 3}, {"ka_r", one}, {"ka_g", one}, {"ka_b", one}, {"ia_r", one}, {"ia_g", one - 1}, {"ia_b", 1}},
        "a second light: exact, and cut at 1");
    add("brighter than 1", {{"i_r", 16 * one - 1}, {"i_g", 16 * one - 1}, {"kd_r", one}}, "cut at exactly 2^O");
    add("ambient above 1", {{"effects", 1}, {"ka_r", one}, {"ia_r", one + 1}}, "one code above 2^O is cut");
    add("kd above 1", {{"kd_r", one + 1}}, "corrected by shade");
    add("ks above 1, diffuse alone", {{"effects", 2}, {"ks_b", one + 1}}, "what is not asked for is not corrected");
    return cases;
}

}  // namespace

Effect pixel_effect() {
    return {"pixel",
            "min(1, shade) of the dot products of L, V, N",
            "B. T. Phong 1975",
            make_pixel,
            emit_pixel,
            pixel_cases,
            1.0,
            true};
}

}  // namespace glint
