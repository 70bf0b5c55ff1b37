#include "glint/hard_cases.hpp"

#include <cmath>

#include <fmt/format.h>

#include "glint/effect.hpp"
#include "glint/lobes.hpp"

namespace glint {

namespace {

/// Of an effect with more ports than these a row has only what differs from the first case.
constexpr std::size_t most_ports = 12;

template <class Item, class Text>
std::string listed(std::span<const Item> items, Text text) {
    std::string out;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const std::string one = text(i);
        if (!one.empty()) out += (out.empty() ? "" : ", ") + one;
    }
    return out;
}

std::string names(std::span<const EffectPort> ports) {
    return listed(ports, [&](std::size_t p) { return std::string(ports[p].name); });
}

}  // namespace

HardCaseTable hard_case_table(const Lobe& lobe) {
    HardCaseTable out{std::string(lobe.name), {"case", "what could go wrong", "covered by"}, 3, {}};
    for (const Profile& profile : shipped_profiles()) {
        const auto model = lobe.golden(profile);
        const std::vector<HardCase> cases = lobe.hard_cases(*model);
        out.columns.push_back(profile.name + ": n, cos code -> y");
        out.rows.resize(cases.size());
        for (std::size_t i = 0; i < cases.size(); ++i) {
            const HardCase& c = cases[i];
            const PortResult result = model->eval_port(c.n, c.cos_code);
            if (out.rows[i].empty()) out.rows[i] = {c.name, c.risk, fmt::format("{}", fmt::join(c.covered, ", "))};
            out.rows[i].push_back(
                fmt::format("{}, {} -> {}{}", c.n, c.cos_code, result.y, result.clamped ? " clamped" : ""));
        }
    }
    return out;
}

HardCaseTable effect_case_table(const Effect& effect) {
    const auto model = effect.golden(parse_profile("p12"), "bps");
    const std::vector<EffectCase> cases = effect.hard_cases(*model);
    const auto ports = model->inputs();
    const bool changes = ports.size() > most_ports;
    HardCaseTable out{"Effect " + std::string(effect.name),
                      {"case", "what could go wrong",
                       fmt::format("p12: {} -> {}", changes ? "what differs from the first case" : names(ports),
                                   names(model->outputs()))},
                      2,
                      {}};
    for (const EffectCase& c : cases) {
        const EffectResult result = model->eval_port(c.in);
        const std::string in = listed(ports, [&](std::size_t p) {
            if (!changes) return fmt::format("{}", c.in[p]);
            return c.in[p] == cases.front().in[p] ? std::string() : fmt::format("{} {}", ports[p].name, c.in[p]);
        });
        const std::string values = listed(std::span<const std::int64_t>(result.values),
                                          [&](std::size_t p) { return fmt::format("{}", result.values[p]); });
        out.rows.push_back(
            {c.name, c.risk,
             fmt::format("{} -> {}{}", in.empty() ? "nothing" : in, values, result.clamped ? " clamped" : "")});
    }
    return out;
}

HardCaseTable render_case_table() {
    return {
        "Pictures",
        {"case", "what could go wrong", "what comes out", "covered by"},
        4,
        {
            {"light, viewer and normal in one line", "the peak is missed, or exceeds what the ports can carry",
             "ambient and diffuse light and the peak of the lobe, each within 2 ulp", "one-line"},
            {"L = -V", "there is no half vector: L + V is 0, and its length divides", "N.H counts as 0",
             "no-half-vector"},
            {"light behind the surface", "a lobe or a negative N.L shines through it", "ambient light alone",
             "light-behind"},
            {"N.L of 0 and of 1 ulp", "the lobe is cut a code too early or too late",
             "nothing at 0, the whole lobe at 1 ulp", "grazing-light"},
            {"normal of length 0, infinite or NaN", "a division by 0; NaN as a code", "ambient light alone",
             "normal-length"},
            {"normal of another length than 1", "dot products are off by it", "that of the unit normal",
             "normal-length"},
            {"dot product above 1", "a code beyond the legal range", "counts as 1; corrections are counted", "above-1"},
            {"light at the very point, attenuation 0 beside it", "0 / 0; an intensity beyond the port",
             "ambient light alone; the greatest code", "distance-0"},
            {"surface at the eye", "V has no direction", "a finite colour", "distance-0"},
            {"position that is NaN", "NaN reaches a port or the picture", "ambient light alone", "no-number"},
            {"no light", "an empty sum; units that are not called for",
             "ambient light alone; without that, no unit and black", "no-light"},
            {"nothing to shade", "a division by 0 fragments; a check on nothing that passes",
             "the background; --compare fails: nothing was shaded", "nothing-to-shade"},
            {"light inside the surface", "the far side is lit through it", "black where there is no ambient light",
             "scenes"},
            {"light on the surface", "an infinite intensity", "a finite picture", "scenes"},
            {"camera inside, camera behind", "surfaces seen from behind are black", "a surface has two sides",
             "scenes"},
            {"empty scene: a model without a face", "a picture of nothing", "one line, exit status 2", "obj-refused"},
            {"NaN or infinity in an OBJ", "it spreads over the picture", "one line with file and line, exit status 2",
             "obj-refused"},
            {"NaN or infinity in an MTL", "it becomes a parameter of a unit",
             "one line with file and line, exit status 2", "mtl-refused"},
            {"degenerate triangle", "its normal is 0 / 0", "it is left out, with a warning", "obj-degenerate"},
            {"missing normals", "flat or black surfaces", "those of the faces around, up to an edge of 60 degrees",
             "obj-no-normals"},
            {"normals of length 0 and not 1 in an OBJ", "a division by 0", "that of the face; unit length",
             "obj-normal-length"},
            {"Ns beyond 1 .. 1023", "an exponent that the port cannot carry", "the nearest legal one, with one warning",
             "mtl-exponent"},
            {"material that a model cannot take", "a parameter beyond its legal range", "the nearest, with a warning",
             "mtl-nearest"},
        }};
}

HardCaseTable stream_case_table() {
    return {"Streams",
            {"case", "what could go wrong", "what comes out", "covered by"},
            4,
            {
                {"stall with a full pipeline", "a result is overwritten or shown twice", "every result once, in order",
                 "exhaustive-stalls, heavy-stalls, handshake"},
                {"bubbles among inputs", "a bubble comes out as a result", "as many results as inputs",
                 "stalls, handshake"},
                {"stall in the clock in which the skid buffer fills", "the item in flight is lost",
                 "it waits in the spare register", "axis-stalls, skid, axis-handshake"},
                {"reset in mid-stream", "old results come out after it", "nothing of what was in flight",
                 "reset, handshake, axis-handshake"},
                {"random register contents at power-up", "a register without reset shows",
                 "only valid bits count, and they are reset; in simulation all others start random",
                 "exhaustive, handshake, axis-handshake"},
                {"another n on every clock", "operands of neighbours mix", "each result is of its own input",
                 "stalls, reset, replay"},
            }};
}

std::string_view hard_case_legend() {
    return "For each named case: the input, what could go wrong, what comes out, and the ids of the tests and proofs "
           "that\n"
           "cover it. A test looks up every id in the list of tests. The cases of an effect are the first inputs of "
           "its\n"
           "cosimulation and of the test of its kernel, and a unit test holds them against the real function, at "
           "every\n"
           "profile; p12 stands for the others here. Pictures have no input of a unit.\n";
}

}  // namespace glint
