#include "wavefront.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include "glint/error.hpp"
#include "glint/profile.hpp"
#include "models.hpp"

namespace glint::render {
namespace {

constexpr double largest_coordinate = 1e12;

/// A line of the file; lines that end with a backslash go on, the number is that of the first.
struct Line {
    int number = 0;
    std::string text;
    std::string after{};  ///< lines of our own that follow
};

std::vector<Line> logical_lines(const std::string& text) {
    std::vector<Line> out;
    std::istringstream in(text);
    std::string line;
    bool open = false;
    for (int number = 1; std::getline(in, line); ++number) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        if (!open) out.push_back({number, {}});
        open = !line.empty() && line.back() == '\\';
        if (open) line.back() = ' ';
        out.back().text += line;
    }
    return out;
}

std::vector<std::string> fields(const std::string& line) {
    std::istringstream in(line);
    std::vector<std::string> out;
    for (std::string field; in >> field && field.front() != '#';) out.push_back(field);
    return out;
}

/// Text of a file for a message or a JSON file: one line, and in UTF-8: bytes that are none become '?'.
std::string printable(const std::string& text) {
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const std::size_t length = byte < 0x80   ? 1
                                   : byte < 0xc2 ? 0
                                   : byte < 0xe0 ? 2
                                   : byte < 0xf0 ? 3
                                   : byte < 0xf5 ? 4
                                                 : 0;
        bool good = length != 0 && i + length <= text.size();
        for (std::size_t k = 1; good && k < length; ++k)
            good = (static_cast<unsigned char>(text[i + k]) & 0xc0U) == 0x80U;
        if (!good) {
            out += '?';
            ++i;
        } else {
            out += byte < 0x20 ? std::string(1, ' ') : text.substr(i, length);
            i += length;
        }
    }
    out.erase(out.find_last_not_of(' ') + 1);
    return out;
}

/// The fields after the key as numbers. tinyobjloader reads as 0 what it cannot read; here that is an error.
std::vector<double> numbers(const std::vector<std::string>& line, const std::string& where) {
    std::vector<double> out;
    for (std::size_t i = 1; i < line.size(); ++i) {
        std::string_view text = line[i];
        if (text.starts_with('+')) text.remove_prefix(1);
        double x = 0.0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
        if (error != std::errc{} || end != text.data() + text.size() || !(std::abs(x) <= largest_coordinate)) {
            throw Error(fmt::format("{}: '{}' is not legal: {} takes numbers from {:g} to {:g}", where,
                                    printable(line[i]), line[0], -largest_coordinate, largest_coordinate));
        }
        out.push_back(x);
    }
    return out;
}

std::string read_text(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    if (file) text << file.rdbuf();
    if (!file || std::filesystem::is_directory(path)) {
        throw Error(fmt::format("file '{}' cannot be read", path.string()));
    }
    return text.str();
}

/// A material's name may hold spaces; where a face asks for it, tinyobjloader takes the first word alone. This
/// character stands for a space inside a name meanwhile.
constexpr char space = '\x1f';

std::string joined(std::vector<Line> lines) {
    std::string out;
    for (Line& line : lines) {
        const std::vector<std::string> words = fields(line.text);
        if (!words.empty() && (words.front() == "newmtl" || words.front() == "usemtl")) {
            std::size_t begin = line.text.find(words.front()) + words.front().size();
            begin = std::min(line.text.find_first_not_of(" \t", begin), line.text.size());
            const std::size_t end = line.text.find_last_not_of(" \t") + 1;
            line.text = words.front() + ' ' + line.text.substr(begin, std::max(begin, end) - begin);
            std::replace(line.text.begin() + static_cast<std::ptrdiff_t>(words.front().size()) + 1, line.text.end(),
                         ' ', space);
        }
        out += line.text + '\n' + line.after;
    }
    return out;
}

/// The text of an MTL file with what tinyobjloader does not know filled in: the defaults of `illum`, `Ni` and `Pr`, and
/// colours of one number, which stands for all three channels.
std::string complete_mtl(const std::string& text, const std::string& file) {
    std::vector<Line> lines = logical_lines(text);
    for (Line& line : lines) {
        const std::vector<std::string> field = fields(line.text);
        if (field.empty()) continue;
        const std::string& key = field.front();
        const bool colour = key == "Ka" || key == "Kd" || key == "Ks";
        if (key == "newmtl") {
            line.after = "illum 2\nNi 1.5\nPr 0.3\n";
        } else if (colour || key == "Ns" || key == "Ni" || key == "Pr" || key == "aniso" || key == "illum") {
            const std::string where = fmt::format("{}:{}", file, line.number);
            const std::vector<double> x = numbers(field, where);
            if (x.size() != 1 && !(colour && x.size() == 3)) {
                throw Error(fmt::format("{}: '{}' has {} numbers, legal {} {}", where, key, x.size(),
                                        colour ? "are" : "is", colour ? "1 or 3" : "1"));
            }
            if (key == "illum" && (x[0] != std::floor(x[0]) || x[0] < 0 || x[0] > 10)) {
                throw Error(fmt::format("{}: illum '{}' is not legal: 0 to 10", where, field[1]));
            }
            if (colour && x.size() == 1) line.text = fmt::format("{} {} {} {}", key, field[1], field[1], field[1]);
        }
    }
    return joined(std::move(lines));
}

/// tinyobjloader has single precision: the number as it stood in the file, if it had no more digits than that.
double decimal(tinyobj::real_t x) { return std::stod(fmt::format("{}", x)); }

Vec3 colour(const tinyobj::real_t (&k)[3], const char* key, const std::string& material,
            std::vector<std::string>& warnings) {
    const Vec3 given{decimal(k[0]), decimal(k[1]), decimal(k[2])};
    const auto cut = [](double x) { return std::clamp(x, 0.0, 1.0); };
    const Vec3 out{cut(given.x), cut(given.y), cut(given.z)};
    if (out != given) {
        warnings.push_back(
            fmt::format("material '{}': {} {:g} {:g} {:g} is cut to 0 .. 1", material, key, given.x, given.y, given.z));
    }
    return out;
}

Material translate(const tinyobj::material_t& mtl, std::vector<std::string>& warnings) {
    Material out;
    out.name = printable(mtl.name);  // and `space` is a space again
    const Vec3 ambient = colour(mtl.ambient, "Ka", out.name, warnings);
    const Vec3 diffuse = colour(mtl.diffuse, "Kd", out.name, warnings);
    const Vec3 specular = colour(mtl.specular, "Ks", out.name, warnings);
    if (mtl.illum == 0) {
        out.emission = diffuse;
    } else {
        out.ambient = ambient;
        out.diffuse = diffuse;
        if (mtl.illum >= 2) out.specular = specular;
    }
    out.exponent = out.specular == Vec3{} ? 1 : exponent(decimal(mtl.shininess), out.name, warnings);
    const auto within = [&](double x, const char* key, double low, double high) {
        if (x < low || x > high) {
            throw Error(fmt::format("material '{}': {} {:g} is not legal: {:g} to {:g}", out.name, key, x, low, high));
        }
        return x;
    };
    out.roughness = within(decimal(mtl.roughness), "Pr", 0.0, 1.0);
    out.anisotropy = within(decimal(mtl.anisotropy), "aniso", 0.0, 0.99);
    out.index = std::max(1.0, within(decimal(mtl.ior), "Ni", 0.0, 10.0));  // files in the wild have 0 for "not given"
    if (mtl.illum >= 3) {
        warnings.push_back(
            fmt::format("material '{}': illum {} also asks for reflection, refraction or shadows, which "
                        "are not rendered; the local part is",
                        out.name, mtl.illum));
    }
    if (!mtl.ambient_texname.empty() || !mtl.diffuse_texname.empty() || !mtl.specular_texname.empty()) {
        warnings.push_back(fmt::format("material '{}': its textures are not rendered; its colours are", out.name));
    }
    const auto named = mtl.unknown_parameter.find("brdf");
    set_models(out, named == mtl.unknown_parameter.end() ? "" : named->second, fmt::format("material '{}'", out.name));
    return out;
}

/// Finds the MTL files of an OBJ file beside it.
class Materials final : public tinyobj::MaterialReader {
public:
    explicit Materials(std::filesystem::path folder) : folder_(std::move(folder)) {}

    bool operator()(const std::string& name, std::vector<tinyobj::material_t>* materials,
                    std::map<std::string, int>* index, std::string* warning, std::string* error) override {
        const std::filesystem::path path = folder_ / name;
        std::error_code unknown;
        if (!std::filesystem::is_regular_file(path, unknown)) return false;
        std::istringstream text(complete_mtl(read_text(path), path.string()));
        tinyobj::LoadMtl(index, materials, &text, warning, error);
        return true;
    }

private:
    std::filesystem::path folder_;
};

/// Normals for corners that have none: the mean of the faces around the vertex, weighted by area, that lie within 60
/// degrees of the corner's own face. So a box keeps its edges and a scanned figure looks smooth.
class Smoothing {
public:
    Smoothing(const std::vector<std::array<int, 3>>& faces, std::vector<Vec3> normals, std::size_t vertices)
        : normals_(std::move(normals)), around_(vertices) {
        for (std::size_t f = 0; f < faces.size(); ++f) {
            for (const int vertex : faces[f]) around_[static_cast<std::size_t>(vertex)].push_back(f);
        }
    }

    Vec3 normal(std::size_t face, int vertex) const {
        const Vec3 own = direction(normals_[face]);
        Vec3 sum;
        for (const std::size_t other : around_[static_cast<std::size_t>(vertex)]) {
            if (dot(direction(normals_[other]), own) > 0.5) sum = sum + normals_[other];
        }
        return direction(sum);
    }

private:
    std::vector<Vec3> normals_;  ///< of each face; its length is twice the area
    std::vector<std::vector<std::size_t>> around_;
};

Vec3 at(const std::vector<tinyobj::real_t>& values, int index) {
    const std::size_t i = 3 * static_cast<std::size_t>(index);
    return {values[i], values[i + 1], values[i + 2]};
}

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
    std::istringstream in(names);
    for (std::string name; in >> name;) {
        const LightingModel* model = find_model(name);
        if (model == nullptr) {
            throw Error(fmt::format("{}: brdf '{}' is not known: {}", where, printable(name), known_models()));
        }
        bool& taken = model->diffuse ? diffuse : specular;
        if (taken) {
            throw Error(fmt::format("{}: brdf '{}' is not legal: a material has one {} model", where, names,
                                    model->diffuse ? "diffuse" : "specular"));
        }
        taken = true;
        std::string& place = model->diffuse ? material.diffuse_model : material.specular_model;
        if (!place.empty()) place = name;
    }
}

std::vector<Material> read_mtl(const std::string& text, const std::string& file, std::vector<std::string>& warnings) {
    std::istringstream in(complete_mtl(text, file));
    std::map<std::string, int> index;
    std::vector<tinyobj::material_t> materials;
    std::string warning;
    std::string error;
    tinyobj::LoadMtl(&index, &materials, &in, &warning, &error);
    std::vector<Material> out;
    for (const tinyobj::material_t& mtl : materials) out.push_back(translate(mtl, warnings));
    return out;
}

Model read_obj(const std::filesystem::path& path, std::vector<std::string>& warnings) {
    const std::string file = path.string();
    const std::vector<Line> lines = logical_lines(read_text(path));
    for (const Line& line : lines) {
        const std::vector<std::string> field = fields(line.text);
        if (field.empty() || (field.front() != "v" && field.front() != "vn")) continue;
        const std::string where = fmt::format("{}:{}", file, line.number);
        if (numbers(field, where).size() < 3) {
            throw Error(
                fmt::format("{}: '{}' has {} numbers, legal are 3 or more", where, field.front(), field.size() - 1));
        }
    }

    std::istringstream in(joined(lines));
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning;
    std::string error;
    Materials reader(path.parent_path());
    if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &in, &reader)) {
        throw Error(fmt::format("{}: {}", file, error.empty() ? "is not a Wavefront OBJ file" : printable(error)));
    }
    if (!warning.empty()) warnings.push_back(fmt::format("{}: {}", file, printable(warning)));

    Model out;
    for (const tinyobj::material_t& mtl : materials) out.materials.push_back(translate(mtl, warnings));
    Material& plain = out.materials.emplace_back();
    plain.name = "(none)";
    plain.ambient = plain.diffuse = {0.7, 0.7, 0.7};
    plain.specular = {0.25, 0.25, 0.25};
    plain.exponent = 40;
    set_models(plain, "", file);

    const int vertices = static_cast<int>(attributes.vertices.size() / 3);
    const int normals = static_cast<int>(attributes.normals.size() / 3);
    std::vector<std::array<int, 3>> faces;  // of the triangles that have an area
    std::vector<std::array<int, 3>> face_normals;
    std::vector<Vec3> crosses;
    std::size_t dropped = 0;
    for (const tinyobj::shape_t& shape : shapes) {
        std::size_t corner = 0;
        for (std::size_t f = 0; f < shape.mesh.num_face_vertices.size(); ++f) {
            const std::size_t first = corner;
            corner += shape.mesh.num_face_vertices[f];
            if (shape.mesh.num_face_vertices[f] != 3) {
                ++dropped;
                continue;
            }
            std::array<int, 3> vertex{};
            std::array<int, 3> normal{};
            for (std::size_t i = 0; i < 3; ++i) {
                const tinyobj::index_t index = shape.mesh.indices[first + i];
                vertex[i] = index.vertex_index;
                normal[i] = index.normal_index;
                if (vertex[i] < 0 || vertex[i] >= vertices || normal[i] >= normals) {
                    const bool bad_normal = vertex[i] >= 0 && vertex[i] < vertices;
                    throw Error(fmt::format("{}: a face asks for {} {}, there are {}", file,
                                            bad_normal ? "normal" : "vertex", 1 + (bad_normal ? normal[i] : vertex[i]),
                                            bad_normal ? normals : vertices));
                }
            }
            const Vec3 a = at(attributes.vertices, vertex[0]);
            const Vec3 area = cross(at(attributes.vertices, vertex[1]) - a, at(attributes.vertices, vertex[2]) - a);
            if (!(dot(area, area) > 0.0)) {
                ++dropped;
                continue;
            }
            Triangle triangle;
            const int material = shape.mesh.material_ids[f];
            triangle.material =
                material < 0 ? static_cast<std::uint32_t>(materials.size()) : static_cast<std::uint32_t>(material);
            for (std::size_t i = 0; i < 3; ++i) {
                triangle.corners[i].position = at(attributes.vertices, vertex[i]);
                if (!attributes.colors.empty()) {
                    const Vec3 c = at(attributes.colors, vertex[i]);
                    triangle.corners[i].colour = {std::clamp(c.x, 0.0, 1.0), std::clamp(c.y, 0.0, 1.0),
                                                  std::clamp(c.z, 0.0, 1.0)};
                }
            }
            out.triangles.push_back(triangle);
            faces.push_back(vertex);
            face_normals.push_back(normal);
            crosses.push_back(area);
        }
    }
    if (out.triangles.empty()) throw Error(fmt::format("{}: there are no faces with an area", file));
    if (dropped != 0) warnings.push_back(fmt::format("{}: {} faces without an area are left out", file, dropped));

    const Smoothing smoothing(faces, crosses, static_cast<std::size_t>(vertices));
    for (std::size_t f = 0; f < faces.size(); ++f) {
        for (std::size_t i = 0; i < 3; ++i) {
            Vec3 normal;
            if (face_normals[f][i] >= 0) normal = direction(at(attributes.normals, face_normals[f][i]));
            if (normal == Vec3{}) normal = smoothing.normal(f, faces[f][i]);
            out.triangles[f].corners[i].normal = normal;
        }
    }
    return out;
}

}  // namespace glint::render
