#include "glint/hard_cases.hpp"

#include <cmath>

#include <fmt/format.h>

#include "glint/lobes.hpp"

namespace glint {

namespace {

std::string markdown(const HardCaseTable& table) {
    const auto line = [](const std::vector<std::string>& cells) {
        std::string out = "|";
        for (const std::string& cell : cells) out += fmt::format(" {} |", cell);
        return out + '\n';
    };
    std::string out = fmt::format("\n## {}\n\n{}|", table.title, line(table.columns));
    for (std::size_t i = 0; i < table.columns.size(); ++i) out += "---|";
    out += '\n';
    for (const std::vector<std::string>& row : table.rows) out += line(row);
    return out;
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
            if (out.rows[i].empty()) out.rows[i] = {c.name, c.risk, c.covered};
            out.rows[i].push_back(
                fmt::format("{}, {} -> {}{}", c.n, c.cos_code, result.y, result.clamped ? " clamped" : ""));
        }
    }
    return out;
}

HardCaseTable stream_case_table() {
    return {"Streams",
            {"case", "what could go wrong", "what comes out", "covered by"},
            4,
            {
                {"stall with a full pipeline", "a result is overwritten or shown twice", "every result once, in order",
                 "cosim.exhaustive_stalls_p8, cosim.heavy_stalls, formal.bps"},
                {"bubbles among inputs", "a bubble comes out as a result", "as many results as inputs",
                 "cosim.stalls, formal.bps"},
                {"stall in the clock in which the skid buffer fills", "the item in flight is lost",
                 "it waits in the spare register", "cosim.axis_stalls, formal.skid, formal.axis.bps"},
                {"reset in mid-stream", "old results come out after it", "nothing of what was in flight",
                 "cosim.reset, formal.bps, formal.axis.bps"},
                {"random register contents at power-up", "a register without reset shows",
                 "only valid bits count, and they are reset",
                 "every cosim run (registers start random), formal.bps, formal.axis.bps (any contents)"},
                {"another n on every clock", "operands of neighbours mix", "each result is of its own input",
                 "cosim.stalls, cosim.reset, replay by Icarus"},
            }};
}

std::string_view hard_case_legend() {
    return "For each named case: the input, what could go wrong, what\n"
           "comes out, and by which test or proof it is covered. `cosim.*`, `formal.*` are CTest names; hls, proof "
           "(Gappa, for "
           "all\n"
           "inputs) and oracle are CTest labels; `unit` is a test case of glint-unit-tests.\n";
}

std::string hard_cases_page() {
    std::string out = "# Hard cases\n\nWritten by `glint cases`; a test keeps it current. ";
    out += hard_case_legend();
    for (const Lobe& lobe : lobes()) out += markdown(hard_case_table(lobe));
    return out + markdown(stream_case_table());
}

}  // namespace glint
