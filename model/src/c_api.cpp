#include "glint.h"

#include <exception>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "glint/effect.hpp"
#include "glint/error.hpp"
#include "glint/lobes.hpp"

using namespace glint;

struct glint_model {
    std::unique_ptr<GoldenModel> lobe;  // this or `effect`
    std::unique_ptr<EffectModel> effect;
    std::vector<std::string> names;  // of the ports: the inputs, then the outputs
    std::vector<glint_port> inputs;
    std::vector<glint_port> outputs;
};

namespace {

thread_local std::string last_error;

/// body(), or `failed` and the text of what it throws: no exception leaves through C.
template <class Result, class Body>
Result guarded(Result failed, const Body& body) {
    try {
        return body();
    } catch (const std::exception& error) {
        last_error = error.what();
    } catch (...) {
        last_error = "unknown error";
    }
    return failed;
}

template <class Pointer>
Pointer there(Pointer pointer, std::string_view what) {
    if (pointer == nullptr) throw Error(fmt::format("{} is not legal: NULL", what));
    return pointer;
}

const GoldenModel& lobe_of(const glint_model* model) {
    if (!there(model, "model")->lobe) throw Error("model is not legal: an effect, where a lobe is wanted");
    return *model->lobe;
}

const EffectModel& effect_of(const glint_model* model) {
    if (!there(model, "model")->effect) throw Error("model is not legal: a lobe, where an effect is wanted");
    return *model->effect;
}

glint_model* with_ports(std::unique_ptr<glint_model> model, const std::vector<EffectPort>& inputs,
                        const std::vector<EffectPort>& outputs) {
    for (const auto* ports : {&inputs, &outputs}) {
        for (const EffectPort& port : *ports) model->names.emplace_back(port.name);
    }
    auto name = model->names.begin();
    for (auto [from, to] : {std::pair(&inputs, &model->inputs), std::pair(&outputs, &model->outputs)}) {
        for (const EffectPort& port : *from) {
            to->push_back(
                {(name++)->c_str(), port.bits, port.is_signed ? 1 : 0, port.fraction_bits, port.low, port.high});
        }
    }
    return model.release();
}

int port_at(const std::vector<glint_port>& ports, std::size_t index, glint_port* port) {
    there(port, "port");
    if (index >= ports.size()) throw Error(fmt::format("index {} is not legal: 0 to {}", index, ports.size() - 1));
    *port = ports[index];
    return 0;
}

}  // namespace

const char* glint_version() { return GLINT_VERSION; }
const char* glint_error() { return last_error.c_str(); }

glint_model* glint_open_lobe(const char* lobe, const char* profile) {
    return guarded<glint_model*>(nullptr, [&] {
        const LobeChoice choice = parse_lobe(there(lobe, "lobe"));
        const Profile parsed = choice.profile(there(profile, "profile"));
        auto model = std::make_unique<glint_model>();
        model->lobe = choice.lobe->golden(parsed);
        using Kind = EffectPort::Kind;
        return with_ports(std::move(model),
                          {{"n", Kind::parameter, 10, false, 0, 1, max_n},
                           {"cos_code", Kind::dot, parsed.F + 2, true, parsed.F, 0, parsed.one()}},
                          {{"y", Kind::term, parsed.O + 1, false, parsed.O, 0, std::int64_t{1} << parsed.O}});
    });
}

glint_model* glint_open_effect(const char* effect, const char* profile, const char* lobe) {
    return guarded<glint_model*>(nullptr, [&] {
        const Effect& found = find_effect(there(effect, "effect"));
        auto model = std::make_unique<glint_model>();
        model->effect = found.golden(parse_profile(there(profile, "profile")), lobe == nullptr ? "bps" : lobe);
        const auto in = model->effect->inputs();
        const auto out = model->effect->outputs();
        return with_ports(std::move(model), {in.begin(), in.end()}, {out.begin(), out.end()});
    });
}

void glint_close(glint_model* model) { delete model; }

size_t glint_input_count(const glint_model* model) { return model == nullptr ? 0 : model->inputs.size(); }
size_t glint_output_count(const glint_model* model) { return model == nullptr ? 0 : model->outputs.size(); }

int glint_input(const glint_model* model, size_t index, glint_port* port) {
    return guarded(-1, [&] { return port_at(there(model, "model")->inputs, index, port); });
}

int glint_output(const glint_model* model, size_t index, glint_port* port) {
    return guarded(-1, [&] { return port_at(there(model, "model")->outputs, index, port); });
}

int glint_eval(const glint_model* model, int32_t n, int64_t cos_code, uint32_t* y) {
    return guarded(-1, [&] {
        *there(y, "y") = lobe_of(model).eval(n, cos_code);
        return 0;
    });
}

int glint_eval_port(const glint_model* model, int32_t n, int64_t cos_code, uint32_t* y, int32_t* clamped) {
    return guarded(-1, [&] {
        there(y, "y");
        there(clamped, "clamped");
        const PortResult result = lobe_of(model).eval_port(n, cos_code);
        *y = result.y;
        *clamped = result.clamped ? 1 : 0;
        return 0;
    });
}

int glint_eval_port_batch(const glint_model* model, size_t count, const uint16_t* n, const int32_t* cos_code,
                          uint32_t* results) {
    return guarded(-1, [&] {
        const GoldenModel& lobe = lobe_of(model);
        if (count == 0) return 0;
        there(n, "n");
        there(cos_code, "cos_code");
        there(results, "results");
        const std::int64_t limit = std::int64_t{2} << lobe.profile().F;
        for (std::size_t i = 0; i < count; ++i) {
            if (n[i] > max_n) throw Error(fmt::format("n[{}] {} is not legal: 0 to {}", i, n[i], max_n));
            if (cos_code[i] < -limit || cos_code[i] >= limit)
                throw Error(fmt::format("cos_code[{}] {} is not legal: {} to {}", i, cos_code[i], -limit, limit - 1));
        }
        lobe.eval_port_batch({n, count}, {cos_code, count}, {results, count});
        return 0;
    });
}

int glint_effect_eval_port(const glint_model* model, const int64_t* in, int64_t* out, int32_t* clamped) {
    return guarded(-1, [&] {
        const EffectModel& effect = effect_of(model);
        there(out, "out");
        there(clamped, "clamped");
        const EffectResult result = effect.eval_port({there(in, "in"), effect.inputs().size()});
        for (std::size_t i = 0; i < result.values.size(); ++i) out[i] = result.values[i];
        *clamped = result.clamped ? 1 : 0;
        return 0;
    });
}

int glint_effect_eval_port_batch(const glint_model* model, size_t count, const int32_t* const* in, int32_t* const* out,
                                 uint8_t* clamped) {
    return guarded(-1, [&] {
        const EffectModel& effect = effect_of(model);
        if (count == 0) return 0;
        there(in, "in");
        there(out, "out");
        there(clamped, "clamped");
        for (std::size_t p = 0; p < model->outputs.size(); ++p) there(out[p], model->outputs[p].name);
        for (std::size_t p = 0; p < model->inputs.size(); ++p) {
            const EffectPort& port = effect.inputs()[p];
            there(in[p], model->inputs[p].name);
            for (std::size_t i = 0; i < count; ++i) {
                if (in[p][i] < port.least() || in[p][i] > port.greatest())
                    throw Error(fmt::format("{}[{}] {} is not legal: {} to {}", port.name, i, in[p][i], port.least(),
                                            port.greatest()));
            }
        }
        effect.eval_port_batch({in, model->inputs.size()}, {out, model->outputs.size()}, {clamped, count});
        return 0;
    });
}
