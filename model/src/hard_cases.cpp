#include "glint/hard_cases.hpp"

#include <cmath>

#include <fmt/format.h>

#include "glint/lobes.hpp"

namespace glint {

std::string hard_cases_page() {
    std::string out =
        "# Hard cases\n\n"
        "Written by `glint cases`; a test keeps it current. For each named case: the input, what could go wrong, what\n"
        "comes out, and by which test or proof it is covered. `cosim.*` are CTest names; hls, proof (Gappa, for all\n"
        "inputs) and oracle are CTest labels; `unit` is a test case of glint-unit-tests.\n";
    for (const Lobe& lobe : lobes()) {
        out += fmt::format("\n## {}\n", lobe.name);
        std::vector<std::unique_ptr<GoldenModel>> models;
        std::vector<std::vector<HardCase>> cases;
        out += "\n| case | what could go wrong | covered by |";
        std::string rule = "\n|---|---|---|";
        for (const Profile& profile : shipped_profiles()) {
            models.push_back(lobe.golden(profile));
            cases.push_back(lobe.hard_cases(*models.back()));
            out += fmt::format(" {}: n, cos code -> y |", profile.name);
            rule += "---|";
        }
        out += rule + '\n';
        for (std::size_t i = 0; i < cases.front().size(); ++i) {
            out += fmt::format("| {} | {} | {} |", cases[0][i].name, cases[0][i].risk, cases[0][i].covered);
            for (std::size_t k = 0; k < models.size(); ++k) {
                const HardCase& c = cases[k][i];
                const PortResult result = models[k]->eval_port(c.n, c.cos_code);
                out += fmt::format(" {}, {} -> {}{} |", c.n, c.cos_code, result.y, result.clamped ? " clamped" : "");
            }
            out += '\n';
        }
    }
    out +=
        "\n## Streams\n\n"
        "| case | what could go wrong | what comes out | covered by |\n"
        "|---|---|---|---|\n"
        "| stall with a full pipeline | a result is overwritten or shown twice | every result once, in order | "
        "cosim.exhaustive_stalls_p8, cosim.heavy_stalls |\n"
        "| bubbles among inputs | a bubble comes out as a result | as many results as inputs | cosim.stalls |\n"
        "| stall in the clock in which the skid buffer fills | the item in flight is lost | it waits in the spare "
        "register | cosim.axis_stalls |\n"
        "| reset in mid-stream | old results come out after it | nothing of what was in flight | cosim.reset "
        "|\n"
        "| random register contents at power-up | a register without reset shows | only valid bits count, and they are "
        "reset | every cosim run (registers start random) |\n"
        "| another n on every clock | operands of neighbours mix | each result is of its own input | cosim.stalls, "
        "cosim.reset, replay by Icarus |\n";
    return out;
}

}  // namespace glint
