#include "glint/emit.hpp"

#include <iterator>
#include <set>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/packages.hpp"
#include "glint/effect.hpp"
#include "glint/error.hpp"
#include "glint/sweep.hpp"
#include "io/command.hpp"

namespace glint::cli {
namespace {

struct EmitOptions {
    std::string effect;
    std::string lobe = "bps";
    std::string profile = "p12";
    std::string architecture;
    std::string sidebands;
    int lanes = 1;
    std::string target = "all";
    std::string folder = ".";
    bool committed = false;
    bool packages = false;
};

std::string_view name(GeneratedFile::Target target) {
    switch (target) {
        case GeneratedFile::Target::verilog:
            return "verilog";
        case GeneratedFile::Target::hls:
            return "hls";
        case GeneratedFile::Target::proof:
            return "proof";
    }
    return "";
}

/// What is known about the error of a custom profile: measured over all inputs where that takes seconds.
std::string measured_bound(const GoldenModel& model) {
    if (model.profile().F > 18) return "not shown (more than 2^28 inputs; `glint sweep` measures a part or all)";
    const SweepResult result =
        sweep(model, {1, max_n, 1}, {0, model.profile().one(), 1}, 0, io::progress_bar("rounding"));
    return fmt::format("{:.4f} ulp, measured over all {} inputs", result.total.rounding.value, result.total.inputs);
}

void write(const std::filesystem::path& path, const std::string& text) {
    io::write_file(path, text);
    fmt::print("{}\n", path.string());
}

/// The manifest of units and a list of the files of each, which is in the folder `generated` with their files.
void write_units(const std::vector<HardwareUnit>& units, const std::filesystem::path& folder,
                 const std::filesystem::path& generated, const FileRoots& in_manifest, const FileRoots& in_lists) {
    write(folder / "units.json", manifest(units, in_manifest));
    for (const HardwareUnit& unit : units) write(generated / (unit.name + ".f"), file_list(unit, in_lists));
}

/// Each file once, though several units may be made of it.
void write(const std::vector<GeneratedFile>& all, const EmitOptions& options) {
    const std::filesystem::path folder = options.folder;
    io::make_folder(options.folder);
    std::set<std::string> names;
    std::vector<GeneratedFile> files;
    for (const GeneratedFile& file : all) {
        if (options.target != "all" && options.target != name(file.target)) continue;
        if (names.insert(file.name).second) files.push_back(file);
    }
    for (const GeneratedFile& file : files) write(folder / file.name, file.text);
    const std::vector<HardwareUnit> units = units_of(files);
    if (units.empty()) return;
    write_units(units, folder, folder, emitted_paths, emitted_list);
    for (const auto& [path, text] : packages(files, "")) write(folder / path, text);
}

/// All of rtl/ that is generated.
void write_committed(const std::filesystem::path& rtl) {
    const std::vector<GeneratedFile> files = committed_verilog();
    io::make_folder((rtl / "generated").string());
    for (const GeneratedFile& file : files) write(rtl / "generated" / file.name, file.text);
    write_units(units_of(files), rtl, rtl / "generated", committed_paths, committed_list);
}

/// What is not committed, for an installed rtl/: FuseSoC cores, VHDL packages, Bender.yml.
void write_packages(const std::filesystem::path& rtl) {
    const std::vector<GeneratedFile> files = committed_verilog();
    io::make_folder((rtl / "generated").string());
    for (const auto& [path, text] : packages(files, "generated")) write(rtl / path, text);
    write(rtl / "glint_by_hand.core", by_hand_core(units_of(files)));
    write(rtl / "Bender.yml", bender(units_of(files)));
}

int run_emit(const EmitOptions& options) {
    if (options.target != "all" && options.target != "verilog" && options.target != "hls" &&
        options.target != "proof") {
        throw Error(fmt::format("target '{}' is not legal: verilog, hls, proof or all", options.target));
    }
    if (options.committed || options.packages) {
        if (options.committed) write_committed(options.folder);
        if (options.packages) write_packages(options.folder);
        return io::success;
    }
    // All before the first is written: a profile that is not legal leaves nothing behind.
    std::vector<GeneratedFile> files;
    const auto add = [&](std::vector<GeneratedFile> more) {
        std::move(more.begin(), more.end(), std::back_inserter(files));
    };
    const Sidebands sidebands = parse_sidebands(options.sidebands);
    const auto axi_stream = [&](std::vector<GeneratedFile> unit) {
        unit = with_axi_stream(std::move(unit), sidebands);
        return options.lanes > 1 ? with_lanes(std::move(unit), options.lanes) : unit;
    };
    if (!options.effect.empty()) {
        const Effect& effect = find_effect(options.effect);
        for (const std::string& text : io::split_profiles(options.profile)) {
            std::vector<GeneratedFile> unit = effect.emit(parse_profile(text), options.lobe);
            if (!options.architecture.empty()) {
                const Architecture architecture = parse_architecture(*unit.front().unit, options.architecture);
                if (!architecture.parameters.empty())
                    throw Error("architecture '" + options.architecture +
                                "' is not legal here: mN is the parameter MULTIPLIER_STAGES of the wrapper");
                use_family(*unit.front().unit, architecture.family);
                if (architecture.block) use_block_tables(unit);
            }
            add(axi_stream(std::move(unit)));
        }
        write(files, options);
        return io::success;
    }
    const LobeChoice choice = parse_lobe(options.lobe);
    const Lobe& lobe = *choice.lobe;
    const Architecture architecture =
        options.architecture.empty() ? default_architecture(lobe) : parse_architecture(lobe, options.architecture);
    const std::vector<std::string> profiles = io::split_profiles(options.profile);
    for (const std::string& text : profiles) {
        add(axi_stream(lobe.emit(choice.profile(text), architecture)));
    }
    write(files, options);
    for (const std::string& text : profiles) {
        const Profile profile = choice.profile(text);
        if (!profile.shipped() || !profile.options.empty()) {
            fmt::print("{} {}: rounding error {}\n", lobe.name, text, measured_bound(*lobe.golden(profile)));
        }
    }
    return io::success;
}

}  // namespace

void add_emit(CLI::App& app, Chosen& chosen) {
    auto options = std::make_shared<EmitOptions>();
    CLI::App* command = app.add_subcommand("emit", "Verilog wrappers, HLS constants and proof scripts of a profile");
    command->add_option("--effect", options->effect, "An effect instead of a lobe (phong, blinn_phong: of --lobe)");
    command->add_option("--lobe", options->lobe, "Lobe, with its options: polynomial:symmetric:0:-1:2")
        ->capture_default_str();
    command->add_option("--profile", options->profile, "Profiles: p8, p12, p16 or the lobe's F,..,O")
        ->capture_default_str();
    command->add_option("--architecture", options->architecture,
                        "How the Verilog is built: iterative, restoring:r2, ... (docs/rtl.md)");
    command->add_option("--sidebands", options->sidebands,
                        "More ports of the AXI4-Stream unit: keep, id, dest (docs/rtl.md)");
    io::add_integer(*command, "--lanes", options->lanes, 2, 64,
                    "Also so many AXI4-Stream units side by side: 2 to 64 (docs/rtl.md)")
        ->default_str("");
    command->add_option("--target", options->target, "verilog, hls, proof or all")->capture_default_str();
    command->add_option("-o,--output", options->folder, "Folder")->capture_default_str();
    command->add_flag("--committed", options->committed,
                      "Write all generated files of rtl/ instead (-o rtl): docs/rtl.md");
    command->add_flag("--packages", options->packages,
                      "Write FuseSoC cores and VHDL packages of rtl/ instead (docs/tools.md)");
    command->footer("Example: glint emit --lobe bps --profile 18,14,14,12 -o out");
    command->callback([=, &chosen] { chosen.run = [=] { return run_emit(*options); }; });
}

}  // namespace glint::cli
