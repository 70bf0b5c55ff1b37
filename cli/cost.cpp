// `glint cost`: the table of accuracy and cost, or what fills it: prices, errors, word lengths.
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cost/accuracy.hpp"
#include "cost/effect_prices.hpp"
#include "cost/fpga/cost.hpp"
#include "cost/grid.hpp"
#include "cost/missing.hpp"
#include "cost/table.hpp"
#include "glint/error.hpp"
#include "io/command.hpp"

namespace glint::cli {

using namespace cost;

namespace {

struct CostOptions {
    bool fpga = false, check = false, accuracy = false, grid = false;
    /// Where they are empty, what they do not name is each part's own default.
    std::string lobe, effect, mask, profile, device, json;
    unsigned jobs = 1, threads = 0;
    TableOptions table;
    fpga::Options on_fpga;
    GridOptions word_lengths;
    std::vector<CLI::Option*> units, of_table, of_fpga, of_grid;  ///< of_table: the last is --data; of_grid: --F, --O
    CLI::Option* dsp = nullptr;
};

/// CostOptions of another part are not passed over in silence.
void refuse(const std::vector<CLI::Option*>& options, bool legal, const std::string& where) {
    for (const CLI::Option* option : options) {
        if (!legal && option->count() > 0) throw Error(option->get_name() + " is not legal here: it is " + where);
    }
}

void set(std::string& value, const std::string& given) {
    if (!given.empty()) value = given;
}

int run_cost(CostOptions options, const std::string& command) {
    if (options.fpga + options.check + options.accuracy + options.grid > 1) {
        throw Error("--fpga, --check, --accuracy and --grid are not legal together: one of them");
    }
    refuse(options.of_fpga, options.fpga, "with --fpga");
    refuse(options.of_grid, options.grid, "with --grid");
    refuse({options.dsp}, options.fpga || options.grid, "with --fpga or --grid");
    refuse(options.of_table, !options.fpga && !options.check && !options.accuracy && !options.grid, "of the table");
    if (options.check) {
        refuse(options.units, false, "of what is measured or shown, and --check takes a whole file");
        fpga::Options& fpga = options.on_fpga;
        fpga.json = options.json;
        fpga.jobs = options.jobs;
        const int status = run_price_check(fpga);
        if (options.json.empty()) {
            for (const std::string& line : cost::not_measured("cost/data")) fmt::print("{}\n", line);
        }
        return status;
    }
    if ((options.accuracy || options.grid) && !(options.effect + options.mask).empty()) {
        throw Error("--effect and --mask are not legal here: they are of --fpga and of the table");
    }
    if (options.fpga) {
        fpga::Options& fpga = options.on_fpga;
        set(fpga.lobe, options.lobe);
        fpga.effect = options.effect;
        fpga.mask = options.mask;
        set(fpga.profile, options.profile);
        set(fpga.device, options.device);
        fpga.json = options.json;
        fpga.jobs = options.jobs;
        return run_fpga(fpga);
    }
    if (options.accuracy) {
        return run_cost_accuracy(options.lobe.empty() ? "all" : options.lobe,
                                 options.profile.empty() ? "p8,p12,p16" : options.profile, options.json,
                                 options.threads);
    }
    if (options.grid) {
        GridOptions& grid = options.word_lengths;
        set(grid.lobe, options.lobe);
        set(grid.device, options.device);
        const bool for_error = grid.max_error > 0.0;
        refuse({options.of_grid[1]}, !for_error, "chosen by the search with --max-error");
        if (for_error && options.lobe.empty()) grid.lobe = "decay";
        if (for_error && options.of_grid[0]->count() == 0) grid.F = 0;
        grid.dsp = options.dsp->count() > 0 && options.on_fpga.dsp == "on";
        if (options.on_fpga.dsp != "on" && options.on_fpga.dsp != "off")
            throw Error(fmt::format("--dsp '{}' is not legal with --grid: on or off", options.on_fpga.dsp));
        grid.rtl = options.on_fpga.rtl;
        grid.cache = options.on_fpga.cache;
        grid.json = options.json;
        grid.jobs = options.jobs;
        grid.threads = options.threads;
        return run_cost_grid(grid);
    }
    if (!options.effect.empty()) {
        refuse({options.of_table.begin(), options.of_table.end() - 1}, false, "of the table of lobes");
        return run_effect_table({options.table.data, options.effect, options.mask, options.lobe, options.profile,
                                 options.device, options.json});
    }
    if (!options.mask.empty())
        throw Error("--mask is not legal without --effect: it is of the effects shade and pixel");
    TableOptions& table = options.table;
    set(table.device, options.device);
    table.lobe = options.lobe;
    table.profile = options.profile;
    table.json = options.json;
    return run_cost_table(table, command);
}

}  // namespace

void add_cost(CLI::App& app, Chosen& chosen) {
    auto o = std::make_shared<CostOptions>();
    CLI::App* command = app.add_subcommand("cost", "What accuracy costs: errors beside cells, clocks and latency");
    command->add_flag("--fpga", o->fpga, "Price units instead: synthesize, place and route (docs/cost.md)");
    command->add_flag("--check", o->check, "List prices that are missing or of other Verilog (--json) instead");
    command->add_flag("--accuracy", o->accuracy, "Measure errors over all inputs instead");
    command->add_flag("--grid", o->grid, "Find the shortest word lengths that will do instead");
    o->units = {
        command->add_option("--lobe", o->lobe, "Lobes, or all; with --fpga also table: a rival, c^n in block RAM"),
        command->add_option("--effect", o->effect, "Effects instead of lobes, or all (made of --lobe; default bps)"),
        command->add_option("--mask", o->mask, "Of shade and pixel: values of MASK; default: a list (docs/cost.md)"),
        command->add_option("--profile", o->profile, "Profiles: p8, p12, p16 or the lobe's F,..,O"),
        command->add_option("--device", o->device,
                            "hx8k (default), up5k, ecp5-25k/85k, lifcl-40, gw2a-18, xc7; table: all"),
    };
    command->add_option("--json", o->json, "Write the table as JSON; merge what is measured into this file");
    TableOptions& table = o->table;
    o->of_table = {
        command->add_option("--n", table.n, "Exponents of the errors: first:last or all")->capture_default_str(),
        command->add_option("--cosine", table.cosine, "Their cosine: rounded or exact")->capture_default_str(),
        command->add_option("--sort", table.sort, "Metric: error, luts, latency, ns, ...")->capture_default_str(),
        command->add_option("--pareto", table.pareto, "Axes on which a row is dominated or not")->capture_default_str(),
        command->add_flag("--hls", table.hls, "Also the HLS kernels, as Bambu made them (hls/README.md)"),
        command->add_option("--csv", table.csv, "Write the table as CSV"),
        command->add_option("--plots", table.plots, "Write its plots to this folder"),
        command->add_option("--data", table.data, "Folder of accuracy.json, fpga.json, effects.json, cpu.json")
            ->capture_default_str(),
    };
    fpga::Options& on_fpga = o->on_fpga;
    o->of_fpga = {
        command->add_option("--architecture", on_fpga.architecture,
                            "--fpga: architectures (docs/rtl.md), or all; else each lobe's default"),
        command->add_flag("--shell", on_fpga.shell, "--fpga: each unit, and its AXI4-Stream unit beside it"),
        io::add_integer(*command, "--lanes", on_fpga.lanes, 2, 64, "--shell: also so many of these side by side"),
        command->add_option("--seeds", on_fpga.seeds, "--fpga: of place and route; the clock is the median")
            ->capture_default_str(),
    };
    o->dsp =
        command->add_option("--dsp", on_fpga.dsp, "--fpga: on (default), off or both; --grid: off (default) or on");
    GridOptions& grid = o->word_lengths;
    o->of_grid = {
        io::add_integer(*command, "--F", grid.F, 8, 30, "--grid: fraction bits of the cosine"),
        io::add_integer(*command, "--O", grid.O, 4, 28, "--grid: fraction bits of the output"),
        io::add_integer(*command, "--most", grid.most, 1, 1000, "--grid: formats to synthesize"),
        io::add_real(*command, "--max-error", grid.max_error, 1e-4, 0.5,
                     "--grid: the cheapest formats of decay for an error against c^n"),
    };
    command->add_option("--rtl", on_fpga.rtl, "Folder of the Verilog")->capture_default_str();
    command->add_option("--cache", on_fpga.cache, "Folder that keeps what was synthesized")->capture_default_str();
    io::add_integer(*command, "-j,--jobs", o->jobs, 0, io::most_threads, "Units at a time; 0: one a core");
    io::add_integer(*command, "--threads", o->threads, 0, io::most_threads,
                    "Threads that measure errors; 0: one a core");
    command->footer("Example: glint cost --device hx8k --n 8:1000 --sort luts");
    command->callback([=, &chosen] { chosen.run = [=, &chosen] { return run_cost(*o, chosen.command); }; });
}

}  // namespace glint::cli
