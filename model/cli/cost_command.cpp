#include "commands.hpp"
#include "common.hpp"
#include "fpga_cost.hpp"
#include "glint/error.hpp"

namespace glint::cli {
namespace {

struct Options {
    bool fpga = false;
    FpgaOptions on_fpga;
};

int run_cost(const Options& options) {
    if (!options.fpga) throw Error("what is to be priced is missing: --fpga");
    return run_fpga(options.on_fpga);
}

}  // namespace

void add_cost(CLI::App& app, Chosen& chosen) {
    auto options = std::make_shared<Options>();
    FpgaOptions& fpga = options->on_fpga;
    CLI::App* command = app.add_subcommand("cost", "What units cost: cells, clock and latency on FPGAs");
    command->add_flag("--fpga", options->fpga, "Synthesize, place and route (docs/cost.md)");
    command->add_option("--lobe", fpga.lobe, "Lobes, separated by commas, or all; table: c^n in block RAM")
        ->capture_default_str();
    command->add_option("--profile", fpga.profile, "Profiles: p8, p12, p16 or the lobe's F,..,O")
        ->capture_default_str();
    command->add_option("--architecture", fpga.architecture,
                        "Architectures, separated by commas, or all; else the default ones");
    command->add_option("--device", fpga.device, "hx8k, up5k, ecp5-25k and xc7, separated by commas")
        ->capture_default_str();
    command->add_option("--dsp", fpga.dsp, "on, off or both: products in DSPs, where the device has any")
        ->capture_default_str();
    command->add_option("--seeds", fpga.seeds, "Seeds of place and route; the clock is the median")
        ->capture_default_str();
    command->add_option("--rtl", fpga.rtl, "Folder of the Verilog")->capture_default_str();
    command->add_option("--cache", fpga.cache, "Folder that keeps what was measured")->capture_default_str();
    command->add_option("--json", fpga.json, "Merge the prices into this file");
    add_integer(*command, "-j,--jobs", fpga.jobs, 0, most_threads, "Units at a time; 0: one a core");
    command->footer("Example: glint cost --fpga --lobe bps --profile p12 --device hx8k,up5k --json cost/fpga.json");
    command->callback([=, &chosen] { chosen.run = [=] { return run_cost(*options); }; });
}

}  // namespace glint::cli
