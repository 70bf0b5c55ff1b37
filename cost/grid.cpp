#include "cost/grid.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cost/accuracy.hpp"
#include "cost/fpga/flow.hpp"
#include "cost/prices.hpp"
#include "glint/architecture.hpp"
#include "glint/error.hpp"
#include "glint/word_lengths.hpp"
#include "io/command.hpp"
#include "io/process.hpp"

namespace glint::cost {

using namespace fpga;

namespace {

using Json = nlohmann::ordered_json;
constexpr std::string_view grid_format = "glint-cost-grid-1";

/// A format: measured over every legal input, and synthesized without DSPs.
struct Row {
    Profile profile;
    AccuracyRecord accuracy;
    Resources resources;
};

struct Grid {
    std::string lobe;
    GuardSearch search;
    std::vector<Row> rows;  ///< the lobe's own first, then the others by their LUTs
};

/// The lobe's own format at F and O: a shipped profile where there is one.
Profile own_profile(const Lobe& lobe, int F, int O) {
    for (const Profile& profile : shipped_profiles()) {
        if (profile.F == F && profile.O == O) return profile;
    }
    return parse_profile(fmt::format("{}", fmt::join(lobe.numbers(F, O), ",")));
}

Resources price(Flow& flow, const Lobe& lobe, const Profile& profile, const GridOptions& options) {
    const std::vector<GeneratedFile> files = lobe.emit(profile, default_architecture(lobe));
    const Unit unit = lobe_unit(files.front().unit->name, profile, 1);
    std::vector<Source> sources = read_sources(options.rtl, design_of(files));
    sources.push_back({"glint_harness.v", harness(unit)});
    const Device& device = find_device(options.device);
    const Resources all = Flow::Netlist(flow, sources, device, Products::gates).resources();
    const Resources around =
        Flow::Netlist(flow, {{"glint_harness.v", harness_alone(unit)}}, device, Products::gates).resources();
    return {all.luts - around.luts, all.registers - around.registers, all.carries - around.carries,
            all.dsps - around.dsps, all.brams - around.brams};
}

Grid measure(Flow& flow, const Lobe& lobe, const GridOptions& options) {
    Grid out;
    out.lobe = lobe.name;
    out.search = find_guard_bits(lobe, {.F = options.F, .O = options.O, .most = options.most}, options.threads);
    std::vector<Profile> profiles = out.search.least;
    const Profile own = own_profile(lobe, options.F, options.O);
    std::erase_if(profiles, [&](const Profile& p) { return p.custom == lobe.numbers(options.F, options.O); });
    profiles.insert(profiles.begin(), own);
    out.rows.resize(profiles.size());
    parallel_tasks(profiles.size(), options.jobs, io::progress_bar(out.lobe), [&] {
        return [&](std::size_t i) { out.rows[i] = {profiles[i], {}, price(flow, lobe, profiles[i], options)}; };
    });
    for (Row& row : out.rows) row.accuracy = measure_accuracy(*lobe.golden(row.profile), options.threads);
    std::stable_sort(out.rows.begin() + 1, out.rows.end(),
                     [](const Row& a, const Row& b) { return a.resources.luts < b.resources.luts; });
    return out;
}

Json to_json(const Grid& grid, const GridOptions& options) {
    Json out{{"lobe", grid.lobe},
             {"F", options.F},
             {"O", options.O},
             {"device", options.device},
             {"dsp", false},
             {"tried", grid.search.tried},
             {"measured", grid.search.measured},
             {"formats", Json::array()}};
    for (const Row& row : grid.rows) {
        out["formats"].push_back({{"profile", row.accuracy.profile},
                                  {"rounding_ulp", row.accuracy.rounding},
                                  {"error", row.accuracy.error({1, max_n, 1}, Cosine::rounded)},
                                  {"error_n8", row.accuracy.error({8, max_n, 1}, Cosine::rounded)},
                                  {"luts", row.resources.luts},
                                  {"registers", row.resources.registers},
                                  {"carries", row.resources.carries},
                                  {"brams", row.resources.brams}});
    }
    return out;
}

Json read_grids(const std::string& path) {
    if (!std::filesystem::is_regular_file(path)) return Json::array();
    const Json file = Json::parse(io::read_file(path), nullptr, false);
    if (!file.is_object() || file.value("format", "") != grid_format || !file.contains("grids")) {
        throw Error(fmt::format("file '{}' is not of the format {}: name another, or remove it", path, grid_format));
    }
    return file["grids"];
}

std::string to_text(const Json& grids, const std::string& yosys) {
    std::string out = fmt::format("{{\"format\": \"{}\",\n \"tools\": {{\"yosys\": {}}},\n \"grids\": [", grid_format,
                                  Json(yosys).dump());
    for (std::size_t i = 0; i < grids.size(); ++i) out += fmt::format("{}\n{}", i == 0 ? "" : ",", grids[i].dump());
    return out + "\n]}\n";
}

std::string to_text(const Grid& grid) {
    std::vector<std::vector<std::string>> rows{
        {"lobe", "profile", "rounding/ulp", "error", "n >= 8", "LUTs", "registers", "BRAMs", "LUTs saved"}};
    const int own = grid.rows.front().resources.luts;
    for (const Row& row : grid.rows) {
        const int saved = own - row.resources.luts;
        rows.push_back({grid.lobe, row.accuracy.profile, fmt::format("{:.4f}", row.accuracy.rounding),
                        short_number(row.accuracy.error({1, max_n, 1}, Cosine::rounded)),
                        short_number(row.accuracy.error({8, max_n, 1}, Cosine::rounded)),
                        std::to_string(row.resources.luts), std::to_string(row.resources.registers),
                        std::to_string(row.resources.brams),
                        &row == grid.rows.data() ? "own" : fmt::format("{} ({:.1f} %)", saved, 100.0 * saved / own)});
    }
    return fmt::format("{}{} formats tried, {} of them over every legal input\n", io::table(rows), grid.search.tried,
                       grid.search.measured);
}

}  // namespace

int run_cost_grid(const GridOptions& options) {
    io::check_writable(options.json);
    find_device(options.device);
    Flow flow(options.cache);
    const std::string yosys = flow.version("yosys");
    Json grids = options.json.empty() ? Json::array() : read_grids(options.json);
    int status = io::success;
    try {
        for (const LobeChoice& choice : io::split_lobes(options.lobe)) {
            const Grid grid = measure(flow, *choice.lobe, options);
            if (grid.search.least.empty()) {
                fmt::print("{}: no format tried keeps the rounding error below the bound of the lobe\n", grid.lobe);
                status = io::check_failed;
                continue;
            }
            fmt::print("{}", to_text(grid));
            Json json = to_json(grid, options);
            const auto same = std::find_if(grids.begin(), grids.end(), [&](const Json& old) {
                return old["lobe"] == json["lobe"] && old["F"] == json["F"] && old["O"] == json["O"] &&
                       old["device"] == json["device"];
            });
            if (same == grids.end()) {
                grids.push_back(std::move(json));
            } else {
                *same = std::move(json);
            }
        }
    } catch (const ToolFailure& failure) {
        fmt::print(stderr, "glint: {}\n", failure.what());
        return io::check_failed;
    }
    if (!options.json.empty() && !grids.empty()) io::write_file(options.json, to_text(grids, yosys));
    return status;
}

}  // namespace glint::cost
