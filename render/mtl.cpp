// MTL files, by the rules of docs/rendering.md.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "glint/error.hpp"
#include "glint/profile.hpp"
#include "models.hpp"
#include "text.hpp"
#include "wavefront.hpp"

namespace glint::render {
namespace {

constexpr double largest_number = 1e12;

/// What a file says of a material.
struct Given {
    std::string name;
    std::optional<Vec3> ambient, diffuse, specular;
    std::optional<double> exponent, roughness, anisotropy, index, illumination;
    std::string models;
    bool textures = false;
    bool diffuse_texture = false;
};

class MtlReader {
public:
    MtlReader(const std::string& file, std::vector<std::string>& warnings) : file_(file), warnings_(warnings) {}

    std::vector<Material> read(std::string_view text) {
        check_text(text, file_);
        static const std::vector<std::string_view> names{"newmtl", "map_Ka", "map_Kd", "map_Ks", "brdf"};
        Lines lines(text, names);
        std::vector<Given> all;
        while (lines.next(line_)) {
            if (line_.key == "newmtl") {
                all.emplace_back().name = line_.rest;
            } else if (!all.empty()) {
                take(all.back());
            } else if (!std::exchange(told_, true)) {
                warn(fmt::format("'{}' before the first newmtl is left out", printable(line_.key)));
            }
        }
        std::vector<Material> out;
        for (const Given& given : all) out.push_back(finish(given));
        return out;
    }

private:
    void warn(const std::string& what) { warnings_.push_back(fmt::format("{}:{}: {}", file_, line_.number, what)); }

    /// The numbers of the line, at least one and at most `most`. None, with a warning, where there are none.
    std::vector<double> numbers(std::size_t most) {
        std::vector<double> out;
        for (const std::string_view field : fields(line_.rest)) {
            double x = 0.0;
            if (!parse_number(field, largest_number, x)) {
                throw Error(fmt::format("{}:{}: '{}' is not legal: {} takes numbers from {:g} to {:g}", file_,
                                        line_.number, printable(field), line_.key, -largest_number, largest_number));
            }
            out.push_back(x);
        }
        if (out.empty()) warn(fmt::format("{} has no number and counts as not given", line_.key));
        if (out.size() > most) {
            warn(fmt::format("{} has {} numbers, the first {} of which count", line_.key, out.size(), most));
            out.resize(most);
        }
        return out;
    }

    void number(std::optional<double>& place) {
        const std::vector<double> x = numbers(1);
        if (!x.empty()) place = x[0];
    }

    void colour(std::optional<Vec3>& place) {
        const std::string_view first = line_.rest.substr(0, line_.rest.find_first_of(" \t"));
        if (first == "spectral" || first == "xyz") {
            warn(fmt::format("{} {} is not read and counts as not given", line_.key, first));
            return;
        }
        const std::vector<double> x = numbers(3);
        if (x.size() == 2) {
            throw Error(fmt::format("{}:{}: '{}' has 2 numbers, legal are 1 or 3", file_, line_.number, line_.key));
        }
        if (!x.empty()) place = x.size() == 1 ? Vec3{x[0], x[0], x[0]} : Vec3{x[0], x[1], x[2]};
    }

    void take(Given& given) {
        const std::string_view key = line_.key;
        if (key == "Ka") colour(given.ambient);
        if (key == "Kd") colour(given.diffuse);
        if (key == "Ks") colour(given.specular);
        if (key == "Ns") number(given.exponent);
        if (key == "Pr") number(given.roughness);
        if (key == "aniso") number(given.anisotropy);
        if (key == "Ni") number(given.index);
        if (key == "illum") number(given.illumination);
        if (key == "brdf") given.models = line_.rest;
        if (key == "map_Ka" || key == "map_Kd" || key == "map_Ks") given.textures = true;
        if (key == "map_Kd") given.diffuse_texture = true;
    }

    std::string of(const Given& given) const { return fmt::format("material '{}'", printable(given.name)); }

    Vec3 cut(const std::optional<Vec3>& k, const char* key, const Given& given) {
        if (!k) return {};
        const auto limit = [](double x) { return std::clamp(x, 0.0, 1.0); };
        const Vec3 out{limit(k->x), limit(k->y), limit(k->z)};
        if (out != *k) {
            warnings_.push_back(
                fmt::format("{}: {} {:g} {:g} {:g} is cut to 0 .. 1", of(given), key, k->x, k->y, k->z));
        }
        return out;
    }

    double within(const std::optional<double>& given, double otherwise, const char* key, double low, double high,
                  const Given& material) {
        const double x = given.value_or(otherwise);
        const double out = std::clamp(x, low, high);
        if (out != x) warnings_.push_back(fmt::format("{}: {} {:g} counts as {:g}", of(material), key, x, out));
        return out;
    }

    int illumination(const Given& given) {
        const double x = given.illumination.value_or(2.0);
        if (x != std::floor(x) || x < 0.0 || x > 10.0) {
            warnings_.push_back(fmt::format("{}: illum {:g} is not known and counts as 2", of(given), x));
            return 2;
        }
        if (x >= 3.0) {
            warnings_.push_back(
                fmt::format("{}: illum {:g} also asks for reflection, refraction or shadows, which "
                            "are not rendered; the local part is",
                            of(given), x));
        }
        return static_cast<int>(x);
    }

    /// The diffuse colour, where there may be none but there has to be one.
    Vec3 diffuse(const Given& given) {
        constexpr double usual = 0.8;
        const bool colourless = !given.ambient && !given.diffuse && !given.specular;
        if (given.diffuse || !(given.diffuse_texture || colourless)) return cut(given.diffuse, "Kd", given);
        warnings_.push_back(fmt::format("{}: without Kd it counts as {:g}", of(given), usual));
        return {usual, usual, usual};
    }

    Material finish(const Given& given) {
        Material out;
        out.name = printable(given.name, 200);
        const Vec3 ambient = cut(given.ambient, "Ka", given);
        const Vec3 base = diffuse(given);
        const Vec3 specular = cut(given.specular, "Ks", given);
        const int illum = illumination(given);
        if (illum == 0) {
            out.emission = base;
        } else {
            out.ambient = ambient;
            out.diffuse = base;
            if (illum >= 2) out.specular = specular;
        }
        if (out.specular != Vec3{}) out.exponent = exponent(given.exponent.value_or(1.0), out.name, warnings_);
        out.roughness = within(given.roughness, out.roughness, "Pr", 0.0, 1.0, given);
        out.anisotropy = within(given.anisotropy, out.anisotropy, "aniso", 0.0, 0.99, given);
        // Files in the wild have 0 for "not given", and indices of less than air's.
        out.index = std::max(1.0, within(given.index, out.index, "Ni", 0.0, 10.0, given));
        if (given.textures) {
            warnings_.push_back(fmt::format("{}: its textures are not rendered; its colours are", of(given)));
        }
        set_models(out, given.models, of(given));
        return out;
    }

    const std::string& file_;
    std::vector<std::string>& warnings_;
    Line line_;
    bool told_ = false;
};

}  // namespace

int exponent(double ns, const std::string& material, std::vector<std::string>& warnings) {
    const double rounded = std::round(ns);
    const int out = static_cast<int>(std::clamp(rounded, 1.0, static_cast<double>(max_n)));
    if (rounded != out) warnings.push_back(fmt::format("material '{}': Ns {:g} counts as {}", material, ns, out));
    return out;
}

void set_models(Material& material, const std::string& names, const std::string& where) {
    material.diffuse_model = material.diffuse == Vec3{} ? "" : "lambert";
    material.specular_model = material.specular == Vec3{} ? "" : "blinn_phong";
    bool diffuse = false;
    bool specular = false;
    for (const std::string_view name : fields(names)) {
        const LightingModel* model = find_model(name);
        if (model == nullptr) {
            throw Error(fmt::format("{}: brdf '{}' is not known: {}", where, printable(name), known_models()));
        }
        bool& taken = model->diffuse ? diffuse : specular;
        if (taken) {
            throw Error(fmt::format("{}: brdf '{}' is not legal: a material has one {} model", where, printable(names),
                                    model->diffuse ? "diffuse" : "specular"));
        }
        taken = true;
        std::string& place = model->diffuse ? material.diffuse_model : material.specular_model;
        if (!place.empty()) place = name;
    }
}

std::vector<Material> read_mtl(std::string_view text, const std::string& file, std::vector<std::string>& warnings) {
    return MtlReader(file, warnings).read(text);
}

}  // namespace glint::render
