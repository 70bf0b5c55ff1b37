// Effects: the terms of a lighting model, as integers that a contract prescribes (docs/effects.md), whoever computes
// them. A lobe is a function of two inputs; an effect is a function of the dot products, of the parameters of a
// material and of colours that it names.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glint/emit.hpp"
#include "glint/golden.hpp"
#include "glint/profile.hpp"

namespace glint {

/// A port of an effect's unit. In Verilog an input is `<name>_i`, an output `<name>_o`.
struct EffectPort {
    /// What feeds it, and when it changes: a dot product of unit vectors (per pixel and light), a parameter of the
    /// material, a colour channel of material or light, the term that another unit computed, or a vector's component.
    enum class Kind { dot, parameter, colour, term, component };
    std::string_view name;
    Kind kind = Kind::dot;
    int bits = 0;            ///< width, the sign included; at most 32, without a sign at most 31
    bool is_signed = false;  ///< two's complement
    int fraction_bits = 0;   ///< value = code / 2^fraction_bits
    std::int64_t low = 0;    ///< legal codes; what lies outside is corrected as the contract says, and raises `clamped`
    std::int64_t high = 0;

    /// What the port can carry.
    std::int64_t least() const { return is_signed ? -(std::int64_t{1} << (bits - 1)) : 0; }
    std::int64_t greatest() const { return (std::int64_t{1} << (is_signed ? bits - 1 : bits)) - 1; }
    /// The code nearest to a real number, halves away from zero, cut to what the port can carry. NaN gives 0.
    std::int64_t code(double x) const;
    double real(std::int64_t code) const;
};

/// What the ports show for one input: a value per output port.
struct EffectResult {
    std::vector<std::int64_t> values;
    bool clamped = false;
    friend bool operator==(const EffectResult&, const EffectResult&) = default;
};

/// An effect at a profile, bit for bit. Immutable, so safe to share between threads.
class EffectModel {
public:
    virtual ~EffectModel() = default;

    std::string_view effect() const { return effect_; }
    const Profile& profile() const { return profile_; }
    std::span<const EffectPort> inputs() const { return inputs_; }
    std::span<const EffectPort> outputs() const { return outputs_; }

    /// The port semantics for one input, a code per input port, each such that the port can carry it. Throws Error.
    EffectResult eval_port(std::span<const std::int64_t> in) const;

    /// eval_port for columns: inputs[p][i] is the code at port p of input i; results go to outputs[p][i] and
    /// clamped[i]. The caller keeps to what the ports can carry. Throws Error when there are not as many columns as
    /// ports.
    void eval_port_batch(std::span<const std::int32_t* const> inputs, std::span<std::int32_t* const> outputs,
                         std::span<std::uint8_t> clamped) const;

    /// Every intermediate value, in the contract's order, ending with the outputs. Throws Error.
    std::vector<Intermediate> trace(std::span<const std::int64_t> in) const;

    /// The real function: a real number per input port gives one per output port. Arguments outside the legal range are
    /// corrected as at the ports; the result is finite for all arguments, NaN among them (it counts as 0), and that of
    /// a term or a colour is not negative.
    std::vector<double> reference(std::span<const double> in) const;

    /// What Effect::bound_ulp is in units of at an input, at least 1: 1 ulp for most effects; results far above 1 are
    /// held to a relative bound where the contract says so. Arguments as of `reference`.
    double bound_scale(std::span<const double> in) const;

protected:
    EffectModel(std::string_view effect, Profile profile, std::vector<EffectPort> inputs,
                std::vector<EffectPort> outputs)
        : effect_(effect), profile_(std::move(profile)), inputs_(std::move(inputs)), outputs_(std::move(outputs)) {}

    /// The codes at the input ports, and then `values`: what most effects have for intermediates.
    std::vector<Intermediate> after_inputs(const std::int64_t* in, std::initializer_list<Intermediate> values) const;

private:
    /// Cuts codes to the legal ranges of their ports; true where that changed any. An effect that is made of others may
    /// leave that to them, and say only whether they do.
    virtual bool correct(std::int64_t* in) const;
    /// eval_port_batch, once the number of columns is right.
    virtual void batch(std::span<const std::int32_t* const> inputs, std::span<std::int32_t* const> outputs,
                       std::span<std::uint8_t> clamped) const;
    /// The effect for codes that are cut to their ports' legal ranges: a code per output port.
    virtual void value(const std::int64_t* in, std::int64_t* out) const = 0;
    /// The same with every intermediate value, the outputs last.
    virtual std::vector<Intermediate> intermediates(const std::int64_t* in) const = 0;
    /// The real function for arguments that are cut to their ports' legal ranges.
    virtual void real(const double* in, double* out) const = 0;
    virtual double scale(const double*) const { return 1.0; }
    /// Whether `real` and `scale` want their arguments as they come.
    virtual bool corrects_itself() const { return false; }
    /// Arguments for `real`. Throws Error when there are not as many as input ports.
    std::vector<double> legal(std::span<const double> in) const;

    std::string_view effect_;  // the registry's literal
    Profile profile_;
    std::vector<EffectPort> inputs_;
    std::vector<EffectPort> outputs_;
};

/// An input at which a fixed-point effect could go wrong.
struct EffectCase {
    std::string name;
    std::vector<std::int64_t> in;  ///< a code per input port
    std::string risk;              ///< what could go wrong there
};

struct Effect {
    std::string_view name;     ///< as on the command line, in scene files and in every file name
    std::string_view formula;  ///< for people
    std::string_view source;   ///< who published it
    /// `lobe` is the lobe of the effects that are made of one (phong, blinn_phong); others take no notice of it.
    /// Throws Error when the profile is not legal for the effect; so does `emit`.
    std::unique_ptr<EffectModel> (*golden)(const Profile& profile, std::string_view lobe);
    std::vector<GeneratedFile> (*emit)(const Profile& profile, std::string_view lobe);
    std::vector<EffectCase> (*hard_cases)(const EffectModel&);
    /// Largest difference of the golden model and the real function at the same codes that the contract states, in ulp
    /// of the output times EffectModel::bound_scale, for the shipped profiles.
    double bound_ulp = 0.0;
    bool takes_lobe = false;
};

/// All effects, in the order of model/registry.cmake.
std::span<const Effect> effects();

/// Throws Error with the list of the known effects.
const Effect& find_effect(std::string_view name);

}  // namespace glint
