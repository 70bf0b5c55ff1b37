// `glint render`: a scene through the effects that it calls for, and how far the engines are apart.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "engine.hpp"
#include "glint/error.hpp"
#include "glint/shade.hpp"
#include "io/command.hpp"
#include "models.hpp"
#include "rtl_unit.hpp"
#include "text.hpp"

namespace glint::cli {
namespace {

using Json = nlohmann::ordered_json;
using namespace render;

struct RenderOptions {
    std::string scene;
    std::string engine = "fixed";
    std::string lobe = "bps";
    std::string profile = "p12";
    std::string output;
    std::string size = "960x540";
    int samples = 1;
    bool all_effects = false;
    bool compare = false;
    std::string from = "dots";
    std::string against;
    std::string against_model;
    std::string json;
    unsigned threads = 0;
};

struct Size {
    int width = 0;
    int height = 0;
};

Size parse_size(const std::string& text) {
    const std::size_t cross = text.find('x');
    if (cross == std::string::npos) throw Error(fmt::format("--size '{}' is not legal: WIDTHxHEIGHT", text));
    constexpr int most = 8192;
    return {static_cast<int>(io::parse_integer(text.substr(0, cross), "--size: width", 1, most)),
            static_cast<int>(io::parse_integer(text.substr(cross + 1), "--size: height", 1, most))};
}

int samples_a_side(int samples) {
    for (int side = 1; side <= 4; ++side) {
        if (side * side == samples) return side;
    }
    throw Error(fmt::format("--samples '{}' is not legal: 1, 4, 9 or 16", samples));
}

std::string unit_name(const UnitPlan& unit) {
    return unit.lobe.empty() ? unit.effect : fmt::format("{} ({})", unit.effect, unit.lobe);
}

/// 1234567 as "1 234 567".
std::string grouped(std::uint64_t number) {
    std::string out = std::to_string(number);
    for (std::size_t i = out.size(); i > 3; i -= 3) out.insert(i - 3, 1, ' ');
    return out;
}

/// The effects that a material calls for, as its line of the plan.
std::string effects_of(const MaterialPlan& material, const Plan& plan, const Scene& scene) {
    std::vector<std::string> names;
    if (material.ambient_shown) names.emplace_back("ambient");
    for (const Term& term : material.terms) {
        if (term.shown) names.push_back(unit_name(plan.units[term.unit]));
    }
    if (scene.materials[material.material].emission != Vec3{}) names.emplace_back("colour alone");
    return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

/// The effects that a MASK builds.
std::vector<std::string_view> built(unsigned mask) {
    std::vector<std::string_view> out = shade_effects();
    std::size_t bit = 0;
    out.erase(std::remove_if(out.begin(), out.end(), [&](std::string_view) { return (mask >> bit++ & 1) == 0; }),
              out.end());
    return out;
}

std::string plan_table(const Plan& plan, const Scene& scene) {
    std::vector<std::vector<std::string>> materials{{"material", "fragments", "effects"}};
    for (const MaterialPlan& material : plan.materials) {
        // A name may hold anything, and the table aligns by the first character.
        materials.push_back({"'" + scene.materials[material.material].name + "'", grouped(material.fragments),
                             effects_of(material, plan, scene)});
    }
    std::vector<std::vector<std::string>> units{{"unit", "evaluations"}};
    const std::vector<UnitPlan>& brought_up = plan.pixels.empty() ? plan.units : plan.pixels;
    for (const UnitPlan& unit : brought_up) units.push_back({unit_name(unit), grouped(unit.evaluations)});
    std::string out = io::table(materials) + "\n" + io::table(units);
    for (const ShadePlan& unit : plan.shade) {
        out +=
            fmt::format("{}{}, MASK {} ({})\n", plan.pixels.empty() ? "as one unit: shade" : "pixel",
                        unit.lobe.empty() ? "" : " (" + unit.lobe + ")", unit.mask, fmt::join(built(unit.mask), ", "));
    }
    if (!plan.not_needed.empty()) out += fmt::format("not needed: {}\n", fmt::join(plan.not_needed, ", "));
    return out;
}

Json plan_json(const Plan& plan, const Scene& scene) {
    Json out{{"materials", Json::array()},
             {"units", Json::array()},
             {"shade", Json::array()},
             {"not_needed", plan.not_needed}};
    for (const MaterialPlan& material : plan.materials) {
        Json effects = Json::array();
        if (material.ambient_shown) effects.push_back("ambient");
        for (const Term& term : material.terms) {
            if (term.shown) effects.push_back(plan.units[term.unit].effect);
        }
        out["materials"].push_back({{"name", scene.materials[material.material].name},
                                    {"fragments", material.fragments},
                                    {"effects", effects}});
    }
    for (const UnitPlan& unit : plan.pixels.empty() ? plan.units : plan.pixels) {
        Json entry{{"effect", unit.effect}};
        if (!unit.lobe.empty()) entry["lobe"] = unit.lobe;
        entry["evaluations"] = unit.evaluations;
        out["units"].push_back(entry);
    }
    for (const ShadePlan& unit : plan.shade) {
        Json entry{{"mask", unit.mask}, {"effects", built(unit.mask)}, {"fragments", unit.fragments}};
        if (!unit.lobe.empty()) entry["lobe"] = unit.lobe;
        out["shade"].push_back(entry);
    }
    return out;
}

/// One engine's picture, and what it took.
struct Result {
    std::string engine;
    Picture picture;
    std::uint64_t corrected = 0;
    std::uint64_t evaluations = 0;
    std::uint64_t clocks = 0;
    double seconds = 0.0;
};

/// What is rendered, once for all engines.
struct Job {
    Scene scene;
    std::vector<Fragment> fragments;
    Size size;
    int side = 1;
    Profile profile;
    unsigned threads = 0;

    Result run(const std::string& engine, const Plan& plan) const {
        MakeUnit make;
        if (engine == "fixed") make = golden_unit;
        if (engine == "rtl") make = rtl_unit;
        Shading shading = shade(scene, plan, fragments, size.width * side, size.height * side, profile, make, threads,
                                io::progress_bar("shading, " + engine));
        Result out{engine, finish(shading.samples, side), shading.corrected, 0, shading.clocks, shading.seconds};
        for (const std::uint64_t count : shading.evaluations) out.evaluations += count;
        return out;
    }
};

Json result_json(const Result& result) {
    Json out{{"engine", result.engine},
             {"shading_seconds", result.seconds},
             {"evaluations", result.evaluations},
             {"corrected", result.corrected}};
    if (result.clocks != 0) out["clocks"] = result.clocks;
    return out;
}

/// Pixels in which two pictures differ, in any bit of a channel.
std::uint64_t unequal_pixels(const Picture& a, const Picture& b) {
    std::uint64_t out = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) out += a.pixels[i] == b.pixels[i] ? 0 : 1;
    return out;
}

/// What the float picture of --compare shows, if not the same as the others.
Plan other_plan(const RenderOptions& options, const Job& job) {
    Scene scene = job.scene;
    if (!options.against_model.empty()) {
        const LightingModel& model = *find_model(options.against_model);
        for (Material& material : scene.materials) {
            std::string& name = model.diffuse ? material.diffuse_model : material.specular_model;
            if (!name.empty()) name = model.name;
        }
        std::vector<std::string> warnings;
        warn_of_limits(scene.materials, warnings);
        for (const std::string& warning : warnings) {
            const std::vector<std::string>& said = job.scene.warnings;
            if (std::find(said.begin(), said.end(), warning) == said.end()) {
                fmt::print(stderr, "glint: warning: {}\n", warning);
            }
        }
    }
    return make_plan(scene, job.fragments, options.against.empty() ? options.lobe : options.against,
                     options.all_effects);
}

/// "out.png", "float" -> "out_float.png".
std::filesystem::path beside(const std::filesystem::path& output, const std::string& part) {
    std::filesystem::path out = output;
    out.replace_filename(output.stem().string() + "_" + part + output.extension().string());
    return out;
}

/// Throws Error where --json would write over one of the files.
void check_apart(const std::string& json, const std::vector<std::filesystem::path>& files, const char* what) {
    if (json.empty()) return;
    if (std::any_of(files.begin(), files.end(), [&](const auto& file) { return io::same_file(json, file); })) {
        throw Error(fmt::format("--json '{}' is not legal: it is {}", json, what));
    }
}

int run_render(const RenderOptions& options, const std::string& command) {
    if (options.engine != "float" && options.engine != "fixed" && options.engine != "rtl") {
        throw Error(fmt::format("--engine '{}' is not legal: float, fixed, rtl", options.engine));
    }
    if (options.from != "dots" && options.from != "vectors") {
        throw Error(fmt::format("--from '{}' is not legal: dots, vectors", options.from));
    }
    const bool vectors = options.from == "vectors";
    if (vectors && options.all_effects) throw Error("--all-effects is not legal with --from vectors");
    if (lower(std::filesystem::path(options.output).extension().string()) != ".png") {
        throw Error(fmt::format("-o '{}' is not legal: a file NAME.png", options.output));
    }
    if (!options.against.empty() && !options.compare) throw Error("--against is not legal without --compare");
    if (!options.against_model.empty() && !options.compare) {
        throw Error("--against-model is not legal without --compare");
    }
    parse_lobe(options.lobe);
    if (!options.against.empty()) parse_lobe(options.against);
    if (!options.against_model.empty() && find_model(options.against_model) == nullptr) {
        throw Error(fmt::format("--against-model '{}' is not known: {}", options.against_model, known_models()));
    }
    std::vector<std::filesystem::path> others{options.scene, options.output};
    for (const char* part : {"float", "fixed", "rtl", "difference"}) {
        if (options.compare) others.push_back(beside(options.output, part));
    }
    check_apart(options.json, others, "the scene or the picture");
    io::check_writable(options.output);
    io::check_writable(options.json);

    Job job;
    job.profile = parse_profile(options.profile);
    job.size = parse_size(options.size);
    job.side = samples_a_side(options.samples);
    job.threads = options.threads;
    constexpr std::int64_t most_rays = std::int64_t{1} << 26;
    const std::int64_t rays = std::int64_t{job.size.width} * job.size.height * options.samples;
    if (rays > most_rays) throw Error(fmt::format("{} rays are not legal: at most {}", rays, most_rays));

    job.scene = load_scene(options.scene, static_cast<double>(job.size.width) / job.size.height);
    check_apart(options.json, job.scene.files, "a model or its materials");
    for (const std::string& warning : job.scene.warnings) fmt::print(stderr, "glint: warning: {}\n", warning);
    const auto start = std::chrono::steady_clock::now();
    job.fragments = cast_rays(job.scene, job.size.width * job.side, job.size.height * job.side, job.threads,
                              io::progress_bar("rays"));
    const double ray_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (job.fragments.empty()) fmt::print(stderr, "glint: warning: nothing is in the picture (0 fragments)\n");
    Plan plan = make_plan(job.scene, job.fragments, options.lobe, options.all_effects);
    if (vectors) plan = from_vectors(std::move(plan), job.scene, options.lobe);
    const std::string obstacle = rtl_obstacle(plan, job.profile);
    if (options.engine == "rtl" && !obstacle.empty()) throw Error(obstacle);

    fmt::print("{}: {} triangles, {} lights; {} x {} pixels, {} rays, {} fragments ({}, {:.2f} s)\n\n{}\n",
               options.scene, grouped(job.scene.triangles.size()), job.scene.lights.size(), job.size.width,
               job.size.height, grouped(static_cast<std::uint64_t>(rays)), grouped(job.fragments.size()), ray_caster(),
               ray_seconds, plan_table(plan, job.scene));
    std::fflush(stdout);
    std::vector<std::string> engines{options.engine};
    if (options.compare) {
        engines = {"float", "fixed"};
        if (obstacle.empty()) engines.emplace_back("rtl");
    }
    // The names that --against and --against-model gave, for what is printed.
    std::vector<std::string> against{options.against, options.against_model};
    against.erase(std::remove(against.begin(), against.end(), ""), against.end());
    std::vector<Result> results;
    for (const std::string& engine : engines) {
        results.push_back(job.run(engine, engine == "float" && !against.empty() ? other_plan(options, job) : plan));
    }
    std::vector<std::vector<std::string>> rows{{"engine", "shading, s", "million evaluations/s", "corrected inputs"}};
    for (const Result& result : results) {
        rows.push_back({result.engine, fmt::format("{:.3f}", result.seconds),
                        fmt::format("{:.1f}", static_cast<double>(result.evaluations) / 1e6 / result.seconds),
                        grouped(result.corrected)});
    }
    fmt::print("{}", io::table(rows));

    Json json{{"tool", "glint render"},
              {"command", command},
              {"scene", options.scene},
              {"lobe", options.lobe},
              {"profile", job.profile.name},
              {"from", options.from},
              {"width", job.size.width},
              {"height", job.size.height},
              {"samples", options.samples},
              {"triangles", job.scene.triangles.size()},
              {"lights", job.scene.lights.size()},
              {"fragments", job.fragments.size()},
              {"ray_caster", ray_caster()},
              {"ray_seconds", ray_seconds},
              {"plan", plan_json(plan, job.scene)},
              {"engines", Json::array()}};
    for (const Result& result : results) json["engines"].push_back(result_json(result));

    bool failed = false;
    std::vector<std::pair<std::filesystem::path, std::string>> files;
    if (!options.compare) {
        files.emplace_back(options.output, png(results.front().picture));
    } else {
        const Picture& real = results[0].picture;
        const Result& last = results.back();
        const Distance distance = compare(last.picture, real);
        const double ulp = std::ldexp(1.0, -job.profile.O);
        fmt::print("\n");
        if (last.engine == "rtl") {
            const std::uint64_t unequal = unequal_pixels(results[1].picture, last.picture);
            fmt::print("rtl against fixed: {} of {} pixels differ\n", unequal, real.pixels.size());
            json["rtl_against_fixed"] = {{"pixels", real.pixels.size()}, {"unequal", unequal}};
            failed = unequal != 0;
        } else {
            fmt::print("rtl against fixed: not compared; {}\n", obstacle);
        }
        fmt::print(
            "{} against float{}: PSNR {:.2f} dB, SSIM {:.5f}, largest difference {} of 255 and {:.2f} ulp of "
            "2^-{} in linear light, {} pixels differ as shown\n",
            last.engine, against.empty() ? "" : fmt::format(" with {}", fmt::join(against, ", ")), distance.psnr,
            distance.ssim, distance.largest, distance.largest_linear / ulp, job.profile.O, grouped(distance.unequal));
        json["against_float"] = {{"engine", last.engine},
                                 {"lobe", options.against.empty() ? options.lobe : options.against},
                                 {"psnr_db", std::isinf(distance.psnr) ? Json() : Json(distance.psnr)},
                                 {"ssim", distance.ssim},
                                 {"largest", distance.largest},
                                 {"largest_linear", distance.largest_linear},
                                 {"largest_linear_ulp", distance.largest_linear / ulp},
                                 {"unequal_pixels", distance.unequal}};
        if (!options.against_model.empty()) json["against_float"]["model"] = options.against_model;
        if (job.fragments.empty()) {
            fmt::print("FAILED: nothing was shaded, so nothing was compared\n");
            failed = true;
        }
        files.emplace_back(beside(options.output, "float"), png(real));
        files.emplace_back(beside(options.output, last.engine), png(last.picture));
        const bool in_ulp = against.empty();
        files.emplace_back(beside(options.output, "difference"),
                           png(difference(last.picture, real, in_ulp ? ulp : 1.0, in_ulp ? "ulp" : "of 1")));
    }
    for (const auto& [file, bytes] : files) {
        io::write_file(file, bytes);
        fmt::print("written: {}\n", file.string());
    }
    if (!options.json.empty()) io::write_json(options.json, json);
    return failed ? io::check_failed : io::success;
}

}  // namespace

void add_render(CLI::App& app, Chosen& chosen) {
    auto options = std::make_shared<RenderOptions>();
    CLI::App* command =
        app.add_subcommand("render", "A picture of a scene, by the effects that its materials call for");
    command->add_option("scene", options->scene, "A scene NAME.json or a model NAME.obj")->required();
    command->add_option("-o,--output", options->output, "The picture, NAME.png")->required();
    command->add_option("--engine", options->engine, "float: real functions; fixed: golden models; rtl: the Verilog")
        ->capture_default_str();
    command->add_option("--lobe", options->lobe, "Lobe of highlights, where the scene names none")
        ->capture_default_str();
    command->add_option("--from", options->from, "fixed, rtl: dots (terms from dot products) or vectors (pixels)")
        ->capture_default_str();
    command->add_option("--profile", options->profile, "Profile: p8, p12, p16 or F,..,O")->capture_default_str();
    command->add_option("--size", options->size, "Width and height in pixels")->capture_default_str();
    io::add_integer(*command, "--samples", options->samples, 1, 16, "Samples a pixel: 1, 4, 9 or 16");
    command->add_flag("--all-effects", options->all_effects, "Every unit evaluates every fragment, needed or not");
    command->add_flag("--compare", options->compare, "All engines, and NAME_difference.png; exit 1 unless fixed = rtl");
    command->add_option("--against", options->against, "With --compare: the lobe of the float picture");
    command->add_option("--against-model", options->against_model,
                        "With --compare: the lighting model of the float picture");
    command->add_option("--json", options->json, "Write plan, times and differences");
    io::add_integer(*command, "--threads", options->threads, 0, io::most_threads, "Threads; 0: one a core");
    command->footer("Example: glint render scenes/still_life.json --engine rtl --samples 4 -o still_life.png");
    command->callback([=, &chosen] { chosen.run = [=, &chosen] { return run_render(*options, chosen.command); }; });
}

}  // namespace glint::cli
