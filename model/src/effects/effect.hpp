// What the files of the effects share: the ports of docs/effects.md, the generated files, hard cases.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "../lobes/lobe.hpp"
#include "glint/effect.hpp"
#include "glint/error.hpp"
#include "glint/fixed_point.hpp"

namespace glint {

/// The golden model of an effect without a lobe.
template <class Model>
std::unique_ptr<EffectModel> make_model(const Profile& profile, std::string_view) {
    return std::make_unique<Model>(profile);
}

/// A dot product of unit vectors: F + 2 bits, legal -1 .. 1.
EffectPort dot_port(std::string_view name, const Profile& profile);

/// The exponent n: 10 bits, legal 1 .. 1023.
EffectPort exponent_port();

/// A channel of a material's colour: O + 1 bits, legal 0 .. 1.
EffectPort material_colour_port(std::string_view name, const Profile& profile);

/// A channel of a light's colour, or of colours' products: O + 4 bits, below 16.
EffectPort light_colour_port(std::string_view name, const Profile& profile);

/// A term, or a colour made of terms: O + 1 + E bits, unsigned, all codes legal.
EffectPort term_port(std::string_view name, const Profile& profile, int E);

/// A component of a vector: W bits with a sign, W - 1 fraction bits, all codes legal.
EffectPort component_port(std::string_view name, int W);

/// Throws Error unless O <= `greatest_O` (and O <= F where a cosine is rounded to a result). An effect without guard
/// bits of its own takes F and O of a custom profile; the numbers between them are a lobe's.
void check_output_bits(std::string_view effect, const Profile& profile, int greatest_O);

/// glint_effect_<effect>_<profile>, or glint_effect_<effect>_<lobe>_<profile> where `lobe` is not empty.
std::string effect_module_name(const EffectModel& model, std::string_view lobe);

/// The Verilog module of that name, with the ports of the model around `body` (lines that end with a line feed). `core`
/// is the module by hand inside, `choices` are parameters of the module beside TAG_W.
GeneratedFile effect_module(const EffectModel& model, std::string_view lobe, const Hardware& hardware,
                            std::string_view core, std::string_view body,
                            const std::vector<HardwareUnit::Parameter>& choices = {});

/// The Verilog wrapper glint_effect_<effect>_<profile>: effect_module with the module glint_effect_<effect> inside.
/// `parameters` are its parameters beside TAG_W, its ports are those of the model; the tables stand beside it as with a
/// lobe, `choices` are parameters of both.
GeneratedFile effect_wrapper(const EffectModel& model, const Hardware& hardware,
                             const std::vector<Constant>& parameters, const std::vector<Table>& tables = {},
                             const std::vector<HardwareUnit::Parameter>& choices = {});

/// A unit made of others: its file, then the Verilog of its parts, each once; their files become the unit's.
std::vector<GeneratedFile> made_of(GeneratedFile file, std::vector<GeneratedFile> parts,
                                   const HardwareUnit::Architecture& timing);

/// The HLS header glint_effect_<effect>_<profile>_constants.hpp, and the top function of the kernel.
GeneratedFile effect_top(const EffectModel& model);
GeneratedFile effect_constants(const EffectModel& model, const std::vector<Constant>& constants,
                               const std::vector<Table>& tables = {});

/// The cases that belong to every effect: for each input, with the others at the middle of their legal range, its legal
/// ends, one ulp inside and beyond them, 0 and its neighbours. An effect's own come after them.
std::vector<EffectCase> common_effect_cases(const EffectModel& model);

}  // namespace glint
