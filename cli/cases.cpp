#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "glint/effect.hpp"
#include "glint/hard_cases.hpp"
#include "glint/lobes.hpp"
#include "io/command.hpp"

namespace glint::cli {
namespace {

/// Of all lobes, of all effects, of pictures and of the streams.
std::vector<HardCaseTable> all_tables() {
    std::vector<HardCaseTable> out;
    for (const Lobe& lobe : lobes()) out.push_back(hard_case_table(lobe));
    for (const Effect& effect : effects()) out.push_back(effect_case_table(effect));
    out.push_back(render_case_table());
    out.push_back(stream_case_table());
    return out;
}

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

std::string page() {
    std::string out = fmt::format(
        "# Hard cases\n\nWritten by `glint cases`; a test keeps it current. tests/hard_cases/covered.json has the "
        "tests of "
        "each id.\n{}",
        hard_case_legend());
    for (const HardCaseTable& table : all_tables()) out += markdown(table);
    return out;
}

nlohmann::ordered_json json() {
    auto out = nlohmann::ordered_json::array();
    for (const HardCaseTable& table : all_tables()) {
        const bool lobe = std::ranges::find(lobes(), table.title, &Lobe::name) != lobes().end();
        out.push_back({{"title", table.title}, {"lobe", lobe}, {"columns", table.columns}, {"rows", table.rows}});
    }
    return {{"tables", out}};
}

}  // namespace

void add_cases(CLI::App& app, Chosen& chosen) {
    auto output = std::make_shared<std::string>();
    auto json_file = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand("cases", "The hard cases by name, with what comes out (docs/hard-cases.md)");
    command->add_option("-o,--output", *output, "Write the page there instead of to standard output");
    command->add_option("--json", *json_file, "Write the tables as JSON");
    command->footer("Example: glint cases -o docs/hard-cases.md");
    command->callback([=, &chosen] {
        chosen.run = [=] {
            io::check_writable(*output, *json_file);
            if (!json_file->empty()) io::write_json(*json_file, json());
            if (!output->empty()) io::write_file(*output, page());
            if (output->empty() && json_file->empty()) fmt::print("{}", page());
            return io::success;
        };
    });
}

}  // namespace glint::cli
