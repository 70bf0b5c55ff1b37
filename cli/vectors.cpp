#include "glint/vectors.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "glint/effect.hpp"
#include "glint/lobes.hpp"
#include "io/command.hpp"

namespace glint::cli {
namespace {

struct VectorsOptions {
    std::string effect;
    std::string lobe = "bps";
    std::string profile = "p12";
    std::size_t count = 10000;
    std::uint64_t seed = 1;
    std::string format = "tv";
    std::string folder = ".";
};

/// Writes the file of vectors and its manifest.
void write(const VectorsOptions& options, const std::string& command, const nlohmann::ordered_json& unit,
           const Profile& profile, std::size_t corners, const std::string& vectors) {
    const std::string name = fmt::format("glint_{}{}_{}", unit.contains("effect") ? "effect_" : "",
                                         unit.value("effect", unit.value("lobe", std::string())), profile.name);
    const std::filesystem::path path = std::filesystem::path(options.folder) / name;
    nlohmann::ordered_json manifest{{"file", name + "." + options.format}, {"format", options.format}};
    manifest.update(unit);
    manifest.update({
        {"profile", profile.name},
        {"F", profile.F},
        {"O", profile.O},
        {"count", options.count},
        {"corners", corners},
        {"seed", options.seed},
        {"version", GLINT_VERSION},
        {"command", command},
    });
    io::write_file(path.string() + "." + options.format, vectors);
    io::write_json(path.string() + ".json", manifest);
    fmt::print("{}.{}: {} vectors, seed {}\n", path.string(), options.format, options.count, options.seed);
}

int run_vectors(const VectorsOptions& options, const std::string& command) {
    const VectorFormat format = parse_vector_format(options.format);
    io::make_folder(options.folder);
    if (options.effect.empty()) {
        for (const auto& model : io::models(options.lobe, options.profile)) {
            const std::vector<TestVector> vectors = make_vectors(*model, options.count, options.seed);
            write(options, command, {{"lobe", model->lobe()}}, model->profile(), corner_vectors(*model).size(),
                  format_vectors(vectors, format));
        }
        return io::success;
    }
    const Effect& effect = find_effect(options.effect);
    for (const std::string& profile : io::split_profiles(options.profile)) {
        const auto model = effect.golden(parse_profile(profile), options.lobe);
        const std::vector<EffectVector> vectors = make_vectors(effect, *model, options.count, options.seed);
        nlohmann::ordered_json unit{{"effect", effect.name}};
        if (effect.takes_lobe) unit["lobe"] = options.lobe;
        unit["fields"] = nlohmann::ordered_json::array();
        for (const EffectPort& port : model->inputs()) unit["fields"].push_back(port.name);
        for (const EffectPort& port : model->outputs()) unit["fields"].push_back(port.name);
        unit["fields"].push_back("clamped");
        write(options, command, unit, model->profile(), corner_vectors(effect, *model, options.seed).size(),
              format_vectors(*model, vectors, format));
    }
    return io::success;
}

}  // namespace

void add_vectors(CLI::App& app, Chosen& chosen) {
    auto options = std::make_shared<VectorsOptions>();
    CLI::App* command = app.add_subcommand("vectors", "Test vectors with the golden results, and a JSON manifest");
    command->add_option("--lobe", options->lobe, "Lobes, separated by commas")->capture_default_str();
    command->add_option("--effect", options->effect, "An effect instead of a lobe (phong, blinn_phong: of --lobe)");
    command->add_option("--profile", options->profile, "Profiles: p8, p12, p16 or the lobe's F,..,O")
        ->capture_default_str();
    io::add_integer(*command, "--count", options->count, 1, 10'000'000, "Vectors, the corners among them");
    io::add_integer(*command, "--seed", options->seed, 0, io::largest_seed, "Seed of the random ones");
    command->add_option("--format", options->format, "tv, csv or hex ($readmemh)")->capture_default_str();
    command->add_option("-o,--output", options->folder, "Folder")->capture_default_str();
    command->footer("Example: glint vectors --lobe bps --profile p12 --count 10000 --seed 1 --format tv -o vectors");
    command->callback([=, &chosen] { chosen.run = [=, &chosen] { return run_vectors(*options, chosen.command); }; });
}

}  // namespace glint::cli
