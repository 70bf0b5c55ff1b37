#include "glint/emit.hpp"

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "glint/effect.hpp"
#include "glint/error.hpp"
#include "glint/sweep.hpp"
#include "io/command.hpp"

namespace glint::cli {
namespace {

struct Options {
    std::string effect;
    std::string lobe = "bps";
    std::string profile = "p12";
    std::string architecture;
    std::string target = "all";
    std::string folder = ".";
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

void write(const std::vector<GeneratedFile>& files, const Options& options) {
    for (const GeneratedFile& file : files) {
        if (options.target != "all" && options.target != name(file.target)) continue;
        const std::filesystem::path path = std::filesystem::path(options.folder) / file.name;
        io::write_file(path, file.text);
        fmt::print("{}\n", path.string());
    }
}

int run_emit(const Options& options) {
    if (options.target != "all" && options.target != "verilog" && options.target != "hls" &&
        options.target != "proof") {
        throw Error(fmt::format("target '{}' is not legal: verilog, hls, proof or all", options.target));
    }
    if (!options.effect.empty()) {
        const Effect& effect = find_effect(options.effect);
        // All before the first is written: a profile that is not legal leaves nothing behind.
        std::vector<std::vector<GeneratedFile>> files;
        for (const std::string& text : io::split_profiles(options.profile)) {
            files.push_back(effect.emit(parse_profile(text), options.lobe));
        }
        io::make_folder(options.folder);
        for (const auto& list : files) write(list, options);
        return io::success;
    }
    io::make_folder(options.folder);
    const LobeChoice choice = parse_lobe(options.lobe);
    const Lobe& lobe = *choice.lobe;
    const Architecture architecture =
        options.architecture.empty() ? default_architecture(lobe) : parse_architecture(lobe, options.architecture);
    for (const std::string& text : io::split_profiles(options.profile)) {
        const Profile profile = choice.profile(text);
        write(lobe.emit(profile, architecture), options);
        if (!profile.shipped() || !profile.options.empty()) {
            fmt::print("{} {}: rounding error {}\n", lobe.name, text, measured_bound(*lobe.golden(profile)));
        }
    }
    return io::success;
}

}  // namespace

void add_emit(CLI::App& app, Chosen& chosen) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("emit", "Verilog wrappers, HLS constants and proof scripts of a profile");
    command->add_option("--effect", options->effect, "An effect instead of a lobe (phong, blinn_phong: of --lobe)");
    command->add_option("--lobe", options->lobe, "Lobe, with its options: polynomial:symmetric:0:-1:2")
        ->capture_default_str();
    command->add_option("--profile", options->profile, "Profiles: p8, p12, p16 or the lobe's F,..,O")
        ->capture_default_str();
    command->add_option("--architecture", options->architecture,
                        "How the Verilog is built: iterative, radix4:r2, ... (docs/rtl.md)");
    command->add_option("--target", options->target, "verilog, hls, proof or all")->capture_default_str();
    command->add_option("-o,--output", options->folder, "Folder")->capture_default_str();
    command->footer("Example: glint emit --lobe bps --profile 18,14,14,12 -o out");
    command->callback([=, &chosen] { chosen.run = [=] { return run_emit(*options); }; });
}

}  // namespace glint::cli
