#include "cost/grid.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cost/accuracy.hpp"
#include "cost/decay_formats.hpp"
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

/// A format: measured over every legal input, and synthesized.
struct Row {
    Profile profile;
    AccuracyRecord accuracy;
    Resources resources;
    double bound = 0.0;  ///< of the error against c^n, proven; 0: none
};

struct Grid {
    std::string lobe;
    int tried = 0;          ///< formats, and
    int looked_into = 0;    ///< of them over every legal input, or by the proof of a bound
    std::vector<Row> rows;  ///< by their LUTs; before them the lobe's own, where no error was asked for

    double error(const Row& row) const { return row.accuracy.error({1, max_n, 1}, Cosine::rounded); }
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
    const Products products = options.dsp ? Products::dsps : Products::gates;
    const Resources all = Flow::Netlist(flow, sources, device, products).resources();
    const Resources around =
        Flow::Netlist(flow, {{"glint_harness.v", harness_alone(unit)}}, device, products).resources();
    return {all.luts - around.luts, all.registers - around.registers, all.carries - around.carries,
            all.dsps - around.dsps, all.brams - around.brams};
}

void measure(Flow& flow, const Lobe& lobe, Grid& grid, const GridOptions& options) {
    parallel_tasks(grid.rows.size(), options.jobs, io::progress_bar(grid.lobe), [&] {
        return [&](std::size_t i) { grid.rows[i].resources = price(flow, lobe, grid.rows[i].profile, options); };
    });
    for (Row& row : grid.rows) row.accuracy = measure_accuracy(*lobe.golden(row.profile), options.threads);
}

bool fewer_luts(const Row& a, const Row& b) { return a.resources.luts < b.resources.luts; }

/// The formats with no bit to spare for the lobe's own promise.
Grid shortest_formats(Flow& flow, const Lobe& lobe, const GridOptions& options) {
    const GuardSearch search =
        find_guard_bits(lobe, {.F = options.F, .O = options.O, .most = options.most}, options.threads);
    Grid out{std::string(lobe.name), search.tried, search.measured, {}};
    if (search.least.empty()) return out;
    out.rows.push_back({own_profile(lobe, options.F, options.O), {}, {}});
    for (const Profile& profile : search.least) {
        if (profile.custom != lobe.numbers(options.F, options.O)) out.rows.push_back({profile, {}, {}});
    }
    measure(flow, lobe, out, options);
    std::stable_sort(out.rows.begin() + 1, out.rows.end(), fewer_luts);
    return out;
}

/// The formats with an error below the one that was asked for, but those that another is better than, or equal to, in
/// LUTs and in block RAMs.
Grid cheapest_formats(Flow& flow, const Lobe& lobe, const GridOptions& options) {
    const DecaySearch search =
        find_decay_formats(find_device(options.device), options.dsp, options.max_error, options.F, options.most);
    Grid out{std::string(lobe.name), search.tried, search.proven, {}};
    for (const DecayFormat& format : search.formats)
        out.rows.push_back({parse_profile(fmt::format("{}", fmt::join(format.numbers, ","))), {}, {}, format.bound});
    measure(flow, lobe, out, options);
    std::stable_sort(out.rows.begin(), out.rows.end(), fewer_luts);
    int brams = std::numeric_limits<int>::max();
    std::erase_if(out.rows, [&](const Row& row) {
        const bool dominated = row.resources.brams >= brams;
        brams = std::min(brams, row.resources.brams);
        return dominated;
    });
    return out;
}

Json to_json(const Grid& grid, const GridOptions& options) {
    Json out{{"lobe", grid.lobe},
             {"F", options.F},
             {"O", options.O},
             {"device", options.device},
             {"dsp", options.dsp},
             {"tried", grid.tried},
             {"measured", grid.looked_into},
             {"formats", Json::array()}};
    if (options.max_error > 0.0) {
        out.erase("O");
        out["max_error"] = options.max_error;
    }
    for (const Row& row : grid.rows) {
        Json format{
            {"profile", row.accuracy.profile},  {"rounding_ulp", row.accuracy.rounding},
            {"error", grid.error(row)},         {"error_n8", row.accuracy.error({8, max_n, 1}, Cosine::rounded)},
            {"luts", row.resources.luts},       {"registers", row.resources.registers},
            {"carries", row.resources.carries}, {"brams", row.resources.brams}};
        if (row.bound > 0.0) {
            format["dsps"] = row.resources.dsps;
            format["bound"] = row.bound;
        }
        out["formats"].push_back(std::move(format));
    }
    return out;
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
                        short_number(grid.error(row)), short_number(row.accuracy.error({8, max_n, 1}, Cosine::rounded)),
                        std::to_string(row.resources.luts), std::to_string(row.resources.registers),
                        std::to_string(row.resources.brams),
                        &row == grid.rows.data() ? "own" : fmt::format("{} ({:.1f} %)", saved, 100.0 * saved / own)});
    }
    return fmt::format("{}{} formats tried, {} of them over every legal input\n", io::table(rows), grid.tried,
                       grid.looked_into);
}

/// Of the formats for an error.
std::string to_text_for_error(const Grid& grid) {
    std::vector<std::vector<std::string>> rows{
        {"lobe", "profile", "error", "proven bound", "LUTs", "registers", "DSPs", "BRAMs"}};
    for (const Row& row : grid.rows) {
        rows.push_back({grid.lobe, row.accuracy.profile, short_number(grid.error(row)), short_number(row.bound),
                        std::to_string(row.resources.luts), std::to_string(row.resources.registers),
                        std::to_string(row.resources.dsps), std::to_string(row.resources.brams)});
    }
    return fmt::format("{}{} formats priced by a model, the bound of {} asked for\n", io::table(rows), grid.tried,
                       grid.looked_into);
}

/// The grids of the file with another one, in the place of one of the same request.
void add_grid(Json& grids, Json json) {
    const auto same = std::find_if(grids.begin(), grids.end(), [&](const Json& old) {
        const auto same_value = [&](const char* key) { return old.value(key, Json()) == json.value(key, Json()); };
        return same_value("lobe") && same_value("F") && same_value("O") && same_value("device") && same_value("dsp") &&
               same_value("max_error");
    });
    if (same == grids.end()) {
        grids.push_back(std::move(json));
    } else {
        *same = std::move(json);
    }
}

}  // namespace

Json read_grids(const std::string& path) {
    if (!std::filesystem::is_regular_file(path)) return Json::array();
    const Json file = Json::parse(io::read_file(path), nullptr, false);
    const Json format = file.is_object() ? file.value("format", Json()) : Json();
    const Json grids = file.is_object() ? file.value("grids", Json()) : Json();
    if (format != grid_format || !grids.is_array() || !std::ranges::all_of(grids, &Json::is_object)) {
        throw Error(fmt::format("file '{}' is not of the format {}: name another, or remove it", path, grid_format));
    }
    return grids;
}

int run_cost_grid(const GridOptions& options) {
    io::check_writable(options.json);
    find_device(options.device);
    for (const LobeChoice& choice : io::split_lobes(options.lobe)) {
        if (options.max_error > 0.0 && choice.lobe->error_bound == nullptr)
            throw Error(fmt::format(
                "--max-error is not legal for the lobe '{}': its error has no proven bound of its own; decay has",
                choice.lobe->name));
    }
    Flow flow(options.cache);
    const std::string yosys = flow.version("yosys");
    if (!options.json.empty()) read_grids(options.json);  // what can be refused is, before the work
    std::vector<Json> found;
    int status = io::success;
    try {
        for (const LobeChoice& choice : io::split_lobes(options.lobe)) {
            const bool for_error = options.max_error > 0.0;
            const Grid grid = for_error ? cheapest_formats(flow, *choice.lobe, options)
                                        : shortest_formats(flow, *choice.lobe, options);
            if (grid.rows.empty()) {
                fmt::print("{}: no format tried keeps the {}\n", grid.lobe,
                           for_error ? fmt::format("error below {}", options.max_error)
                                     : "rounding error below the bound of the lobe");
                status = io::check_failed;
                continue;
            }
            fmt::print("{}", for_error ? to_text_for_error(grid) : to_text(grid));
            found.push_back(to_json(grid, options));
        }
    } catch (const ToolFailure& failure) {
        fmt::print(stderr, "glint: {}\n", failure.what());
        return io::check_failed;
    }
    if (!options.json.empty() && !found.empty()) {
        const io::FolderLock lock(options.json);
        Json grids = read_grids(options.json);  // another run may have added some
        for (Json& grid : found) add_grid(grids, std::move(grid));
        io::write_file(options.json, to_text(grids, yosys));
    }
    return status;
}

}  // namespace glint::cost
