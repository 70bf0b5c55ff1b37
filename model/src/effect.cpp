#include "glint/effect.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "glint/error.hpp"

namespace glint {

// Each effect's own file defines its entry.
#define GLINT_EFFECT(name) Effect name##_effect();
#include "glint/effects.def"
#undef GLINT_EFFECT

std::span<const Effect> effects() {
#define GLINT_EFFECT(name) name##_effect(),
    static const auto all = std::to_array<Effect>({
#include "glint/effects.def"
    });
#undef GLINT_EFFECT
    return all;
}

const Effect& find_effect(std::string_view name) {
    std::string known;
    for (const Effect& effect : effects()) {
        if (effect.name == name) return effect;
        known += fmt::format("{}{}", known.empty() ? "" : ", ", effect.name);
    }
    throw Error(fmt::format("effect '{}' is not known: {}", name, known));
}

std::int64_t EffectPort::code(double x) const {
    if (std::isnan(x)) return 0;
    // Both ends are exact in a double, so that llround sees only what fits.
    const double scaled = std::ldexp(x, fraction_bits);
    if (scaled <= static_cast<double>(least())) return least();
    if (scaled >= static_cast<double>(greatest())) return greatest();
    return std::llround(scaled);
}

double EffectPort::real(std::int64_t code) const { return std::ldexp(static_cast<double>(code), -fraction_bits); }

namespace {

void check_carried(std::string_view effect, std::span<const EffectPort> ports, std::span<const std::int64_t> in) {
    if (in.size() != ports.size()) {
        throw Error(fmt::format("{} values are not legal for {}: {}", in.size(), effect, ports.size()));
    }
    for (std::size_t p = 0; p < ports.size(); ++p) {
        if (in[p] < ports[p].least() || in[p] > ports[p].greatest()) {
            throw Error(fmt::format("{} {} is not legal: the port carries {} to {}", ports[p].name, in[p],
                                    ports[p].least(), ports[p].greatest()));
        }
    }
}

}  // namespace

bool EffectModel::correct(std::int64_t* in) const {
    bool changed = false;
    for (std::size_t p = 0; p < inputs_.size(); ++p) {
        const std::int64_t legal = std::clamp(in[p], inputs_[p].low, inputs_[p].high);
        changed |= legal != in[p];
        in[p] = legal;
    }
    return changed;
}

EffectResult EffectModel::eval_port(std::span<const std::int64_t> in) const {
    check_carried(effect_, inputs_, in);
    EffectResult out{std::vector<std::int64_t>(outputs_.size()), false};
    std::vector<std::int64_t> codes(in.begin(), in.end());
    out.clamped = correct(codes.data());
    value(codes.data(), out.values.data());
    return out;
}

void EffectModel::eval_port_batch(std::span<const std::int32_t* const> inputs, std::span<std::int32_t* const> outputs,
                                  std::span<std::uint8_t> clamped) const {
    if (inputs.size() != inputs_.size() || outputs.size() != outputs_.size()) {
        throw Error(fmt::format("{} and {} columns are not legal for {}: {} and {}", inputs.size(), outputs.size(),
                                effect_, inputs_.size(), outputs_.size()));
    }
    std::vector<std::int64_t> in(inputs.size()), out(outputs.size());
    for (std::size_t i = 0; i < clamped.size(); ++i) {
        for (std::size_t p = 0; p < in.size(); ++p) in[p] = inputs[p][i];
        clamped[i] = correct(in.data()) ? 1 : 0;
        value(in.data(), out.data());
        for (std::size_t p = 0; p < out.size(); ++p) outputs[p][i] = static_cast<std::int32_t>(out[p]);
    }
}

std::vector<Intermediate> EffectModel::trace(std::span<const std::int64_t> in) const {
    check_carried(effect_, inputs_, in);
    std::vector<std::int64_t> codes(in.begin(), in.end());
    correct(codes.data());
    return intermediates(codes.data());
}

std::vector<Intermediate> EffectModel::after_inputs(const std::int64_t* in,
                                                    std::initializer_list<Intermediate> values) const {
    std::vector<Intermediate> out;
    for (std::size_t p = 0; p < inputs_.size(); ++p) out.push_back({inputs_[p].name, in[p], inputs_[p].fraction_bits});
    out.insert(out.end(), values);
    return out;
}

std::vector<double> EffectModel::legal(std::span<const double> in) const {
    if (in.size() != inputs_.size()) {
        throw Error(fmt::format("{} values are not legal for {}: {}", in.size(), effect_, inputs_.size()));
    }
    std::vector<double> arguments(in.begin(), in.end());
    for (std::size_t p = 0; p < arguments.size(); ++p) {
        const double x = std::isnan(arguments[p]) ? 0.0 : arguments[p];
        arguments[p] = std::clamp(x, inputs_[p].real(inputs_[p].low), inputs_[p].real(inputs_[p].high));
    }
    return arguments;
}

std::vector<double> EffectModel::reference(std::span<const double> in) const {
    std::vector<double> out(outputs_.size());
    real(legal(in).data(), out.data());
    return out;
}

double EffectModel::bound_scale(std::span<const double> in) const { return scale(legal(in).data()); }

}  // namespace glint
