#include "glint/vectors.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "io/command.hpp"

namespace glint::cli {
namespace {

struct Options {
    std::string lobe = "bps";
    std::string profile = "p12";
    std::size_t count = 10000;
    std::uint64_t seed = 1;
    std::string format = "tv";
    std::string folder = ".";
};

int run_vectors(const Options& options, const std::string& command) {
    const VectorFormat format = parse_vector_format(options.format);
    io::make_folder(options.folder);
    for (const auto& model : io::models(options.lobe, options.profile)) {
        const std::vector<TestVector> vectors = make_vectors(*model, options.count, options.seed);
        const std::string name = fmt::format("glint_{}_{}", model->lobe(), model->profile().name);
        const std::filesystem::path path = std::filesystem::path(options.folder) / name;
        const nlohmann::ordered_json manifest{
            {"file", name + "." + options.format},
            {"format", options.format},
            {"lobe", model->lobe()},
            {"profile", model->profile().name},
            {"F", model->profile().F},
            {"O", model->profile().O},
            {"count", vectors.size()},
            {"corners", corner_vectors(*model).size()},
            {"seed", options.seed},
            {"version", GLINT_VERSION},
            {"command", command},
        };
        io::write_file(path.string() + "." + options.format, format_vectors(vectors, format));
        io::write_file(path.string() + ".json", manifest.dump(1) + "\n");
        fmt::print("{}.{}: {} vectors, seed {}\n", path.string(), options.format, vectors.size(), options.seed);
    }
    return io::success;
}

}  // namespace

void add_vectors(CLI::App& app, Chosen& chosen) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("vectors", "Test vectors with the golden results, and a JSON manifest");
    command->add_option("--lobe", options->lobe, "Lobes, separated by commas")->capture_default_str();
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
