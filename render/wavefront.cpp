#include "wavefront.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>

#include <fmt/format.h>

#include "glint/error.hpp"
#include "models.hpp"
#include "polygon.hpp"
#include "smoothing.hpp"
#include "text.hpp"

namespace glint::render {
namespace {

constexpr double largest_coordinate = 1e12;
constexpr std::uint32_t no_name = static_cast<std::uint32_t>(-1);
constexpr std::int64_t no_normal = -1;
constexpr Vec3 uncoloured{std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0};

/// What `f` says of a corner, from 0. Both may be too large: a file may name a vertex before it has it.
struct FaceCorner {
    std::int64_t vertex = 0;
    std::int64_t normal = no_normal;
};

struct Face {
    int line = 0;
    std::size_t first = 0;  ///< of its corners
    std::size_t count = 0;
    std::uint32_t name = no_name;  ///< of its material
};

/// How often something was seen, and where first.
struct Seen {
    std::size_t count = 0;
    int line = 0;
    void at(int where) {
        if (count++ == 0) line = where;
    }
};

/// Statements that say nothing of how a face looks here.
bool is_passed_over(std::string_view key) {
    static const std::set<std::string_view> known{
        "vt",       "vp",     "vw",     "g",      "o",     "s",     "mg",         "lod",      "bevel", "c_interp",
        "d_interp", "usemap", "maplib", "cstype", "deg",   "bmat",  "step",       "parm",     "trim",  "hole",
        "scrv",     "sp",     "end",    "con",    "stech", "ctech", "shadow_obj", "trace_obj"};
    return known.contains(key);
}

/// The name without what follows a '#' after a blank; the whole name where there is none.
std::string before_mark(const std::string& name) {
    const std::size_t mark = name.find(" #");
    return std::string(trimmed(name.substr(0, mark)));
}

class ObjReader {
public:
    ObjReader(const std::string& file, const FindFile& find, std::vector<std::string>& warnings)
        : file_(file), find_(find), warnings_(warnings) {}

    Model read(std::string_view text) {
        check_text(text, file_);
        static const std::vector<std::string_view> names{"mtllib", "usemtl", "g", "o"};
        Lines lines(text, names);
        while (lines.next(line_)) take();
        Model out;
        out.materials = std::move(materials_);
        Material& plain = out.materials.emplace_back();
        plain.name = "(none)";
        plain.ambient = plain.diffuse = {0.7, 0.7, 0.7};
        plain.specular = {0.25, 0.25, 0.25};
        plain.exponent = 40;
        set_models(plain, "", file_);
        build(out);
        out.files.assign(libraries_.begin(), libraries_.end());
        return out;
    }

private:
    void warn(const std::string& what) { warnings_.push_back(fmt::format("{}: {}", file_, what)); }
    [[noreturn]] void refuse(int line, const std::string& what) const {
        throw Error(fmt::format("{}:{}: {}", file_, line, what));
    }

    void take() {
        const std::string_view key = line_.key;
        if (key == "v") {
            const std::vector<double> x = numbers();
            vertices_.push_back({x[0], x[1], x[2]});
            if (x.size() >= 6) {
                colours_.resize(vertices_.size(), uncoloured);
                colours_.back() = {x[3], x[4], x[5]};
                brightest_ = std::max({brightest_, x[3], x[4], x[5]});
                darkest_ = std::min({darkest_, x[3], x[4], x[5]});
            }
        } else if (key == "vn") {
            const std::vector<double> x = numbers();
            normals_.push_back({x[0], x[1], x[2]});
        } else if (key == "f" || key == "fo") {
            Face face{line_.number, corners_.size(), 0, name_};
            for (const std::string_view field : fields(line_.rest)) corners_.push_back(corner(field));
            face.count = corners_.size() - face.first;
            faces_.push_back(face);
        } else if (key == "usemtl") {
            const std::string name = printable(line_.rest, 200);
            const auto [place, fresh] = name_numbers_.try_emplace(name, static_cast<std::uint32_t>(names_.size()));
            if (fresh) names_.push_back(name);
            name_ = place->second;
        } else if (key == "mtllib") {
            const bool quoted = line_.rest.size() > 2 && line_.rest.starts_with('"') && line_.rest.ends_with('"');
            read_library(std::string(quoted ? line_.rest.substr(1, line_.rest.size() - 2) : line_.rest));
        } else if (key == "l" || key == "p" || key == "curv" || key == "curv2" || key == "surf") {
            not_drawn_.at(line_.number);
        } else if (!is_passed_over(key)) {
            unknown_.at(line_.number);
        }
    }

    /// The numbers of `v` and `vn`: at least 3.
    std::vector<double> numbers() const {
        std::vector<double> out;
        for (const std::string_view field : fields(line_.rest)) {
            double x = 0.0;
            if (!parse_number(field, largest_coordinate, x)) {
                refuse(line_.number, fmt::format("'{}' is not legal: {} takes numbers from {:g} to {:g}",
                                                 printable(field), line_.key, -largest_coordinate, largest_coordinate));
            }
            out.push_back(x);
        }
        if (out.size() < 3) {
            refuse(line_.number, fmt::format("'{}' has {} numbers, legal are 3 or more", line_.key, out.size()));
        }
        return out;
    }

    /// v, v/vt, v//vn or v/vt/vn, where what follows a '/' may be missing.
    FaceCorner corner(std::string_view field) {
        std::array<std::string_view, 3> parts;
        std::size_t part = 0;
        for (std::string_view rest = field;; ++part) {
            const std::size_t slash = rest.find('/');
            if (part < 3) parts[part] = rest.substr(0, slash);
            if (slash == rest.npos) break;
            rest.remove_prefix(slash + 1);
        }
        std::array<std::int64_t, 3> index{};
        for (std::size_t i = 0; i < 3; ++i) {
            if (i > 0 && parts[i].empty()) continue;
            const char* const end = parts[i].data() + parts[i].size();
            const auto [stopped, error] = std::from_chars(parts[i].data(), end, index[i]);
            if (error == std::errc::result_out_of_range && stopped == end) {
                index[i] = parts[i].starts_with('-') ? -most_index : most_index;
            } else if (part > 2 || stopped != end || error != std::errc{}) {
                refuse(line_.number, fmt::format("'{}' is not legal: a corner of a face is v, v/vt, v//vn or v/vt/vn, "
                                                 "whole numbers",
                                                 printable(field)));
            }
        }
        FaceCorner out;
        const auto vertices = static_cast<std::int64_t>(vertices_.size());
        if (index[0] == 0 || index[0] < -vertices || index[0] == most_index) {
            refuse(line_.number, fmt::format("a face asks for vertex {}, there are {} before it; the first is 1",
                                             printable(parts[0]), vertices));
        }
        out.vertex = index[0] < 0 ? vertices + index[0] : index[0] - 1;
        const auto normals = static_cast<std::int64_t>(normals_.size());
        if (index[2] > 0) out.normal = index[2] - 1;
        if (index[2] < 0) out.normal = index[2] < -normals ? most_index : normals + index[2];
        return out;
    }

    /// The names on a line of `mtllib`: one that may hold blanks, or several, or both.
    void read_library(const std::string& names) {
        if (names.empty() || read_materials(names)) return;
        std::vector<std::string> words;
        for (const std::string_view field : fields(names)) {
            // "a\ b.mtl" is one name.
            if (!words.empty() && words.back().ends_with('\\')) {
                words.back().back() = ' ';
                words.back() += field;
            } else {
                words.emplace_back(field);
            }
        }
        constexpr std::size_t most_words = 16;
        words.resize(std::min<std::size_t>(words.size(), 64));  // each is looked for in the folder
        bool found = false;
        std::vector<std::string> missing;
        for (std::size_t first = 0; first < words.size();) {
            std::size_t last = first;
            for (std::size_t end = std::min(words.size(), first + most_words); end > first && last == first; --end) {
                const std::string name =
                    fmt::format("{}", fmt::join(words.begin() + static_cast<std::ptrdiff_t>(first),
                                                words.begin() + static_cast<std::ptrdiff_t>(end), " "));
                if (read_materials(name)) last = end;
            }
            if (last == first) missing.push_back(words[first]);
            found = found || last != first;
            first = std::max(last, first + 1);
        }
        if (missing.empty()) return;
        library_missing_ = true;
        warn(fmt::format("material file '{}' is not there: what it defines is grey",
                         printable(found ? fmt::format("{}", fmt::join(missing, " ")) : names)));
    }

    /// False where there is no file of that name.
    bool read_materials(const std::string& name) {
        const std::filesystem::path path = find_(name);
        if (path.empty()) return false;
        if (!libraries_.insert(path).second) return true;
        const std::string text = read_file(path);
        for (Material& material : read_mtl(text, printable(path.string(), 200), warnings_)) {
            materials_.push_back(std::move(material));
        }
        return true;
    }

    /// The material of each name that `usemtl` gave; of those without one the last, which is plain.
    std::vector<std::uint32_t> find_materials(const Model& model) {
        std::map<std::string, std::uint32_t> whole;
        std::map<std::string, std::uint32_t> cut;
        const auto plain = static_cast<std::uint32_t>(model.materials.size() - 1);
        for (std::uint32_t m = 0; m < plain; ++m) {
            whole.try_emplace(model.materials[m].name, m);
            cut.try_emplace(before_mark(model.materials[m].name), m);
        }
        std::vector<std::uint32_t> out;
        for (const std::string& name : names_) {
            const auto same = whole.find(name);
            const auto like = cut.find(before_mark(name));
            out.push_back(same != whole.end() ? same->second : like != cut.end() ? like->second : plain);
        }
        return out;
    }

    /// Colours of vertices as 0 .. 1.
    void scale_colours() {
        colours_.resize(colours_.empty() ? 0 : vertices_.size(), uncoloured);
        const bool bytes = brightest_ >= 2.0;
        if (bytes) {
            warn(fmt::format("colours of vertices above 1 were taken as 0 .. 255{}",
                             brightest_ > 255.0 || darkest_ < 0.0 ? ", and cut to that" : ""));
        } else if (brightest_ > 1.0 || darkest_ < 0.0) {
            warn("colours of vertices are cut to 0 .. 1");
        }
        const auto channel = [&](double x) { return std::clamp(bytes ? x / 255.0 : x, 0.0, 1.0); };
        for (Vec3& c : colours_) c = c.x != c.x ? Vec3{1, 1, 1} : Vec3{channel(c.x), channel(c.y), channel(c.z)};
    }

    void build(Model& out) {
        const std::vector<std::uint32_t> materials = find_materials(out);
        const auto plain = static_cast<std::uint32_t>(out.materials.size() - 1);
        scale_colours();
        std::vector<std::array<std::uint32_t, 3>> triangles;
        std::vector<std::array<std::int64_t, 3>> normals;
        std::vector<Vec3> areas;
        std::size_t dropped = 0;
        Seen crossing, normal_missing;
        std::set<std::string> undefined;
        std::vector<Vec3> polygon;
        for (const Face& face : faces_) {
            const std::span<FaceCorner> corners(corners_.data() + face.first, face.count);
            polygon.clear();
            for (FaceCorner& corner : corners) {
                if (corner.vertex >= static_cast<std::int64_t>(vertices_.size())) {
                    refuse(face.line,
                           fmt::format("a face asks for vertex {}, there are {}", corner.vertex + 1, vertices_.size()));
                }
                if (corner.normal >= static_cast<std::int64_t>(normals_.size())) {
                    normal_missing.at(face.line);
                    corner.normal = no_normal;
                }
                polygon.push_back(vertices_[static_cast<std::size_t>(corner.vertex)]);
            }
            const Triangulation cut = triangulate(polygon);
            if (!cut.simple) crossing.at(face.line);
            if (cut.triangles.empty()) ++dropped;
            const std::uint32_t material = face.name == no_name ? plain : materials[face.name];
            if (face.name != no_name && material == plain) undefined.insert(names_[face.name]);
            for (const auto& triangle : cut.triangles) {
                Triangle& made = out.triangles.emplace_back();
                made.material = material;
                auto& vertex = triangles.emplace_back();
                auto& normal = normals.emplace_back();
                for (std::size_t i = 0; i < 3; ++i) {
                    vertex[i] = static_cast<std::uint32_t>(corners[triangle[i]].vertex);
                    normal[i] = corners[triangle[i]].normal;
                    made.corners[i].position = vertices_[vertex[i]];
                    if (!colours_.empty()) made.corners[i].colour = colours_[vertex[i]];
                }
                const Vec3& a = made.corners[0].position;
                areas.push_back(cross(made.corners[1].position - a, made.corners[2].position - a));
            }
        }
        if (out.triangles.empty()) throw Error(fmt::format("{}: there are no faces with an area", file_));
        set_normals(out, triangles, normals, areas);

        const auto some = [&](const Seen& seen, const char* one, const char* many, const char* what) {
            if (seen.count == 0) return;
            warn(fmt::format("{} {} {}, the first in line {}", seen.count, seen.count == 1 ? one : many, what,
                             seen.line));
        };
        some(unknown_, "line is", "lines are", "no OBJ and left out");
        some(not_drawn_, "point, line, curve or surface is", "points, lines, curves and surfaces are", "not drawn");
        some(crossing, "face crosses or covers", "faces cross or cover", "itself");
        some(normal_missing, "corner has", "corners have", "a normal that is not there; it is made from the faces");
        if (!undefined.empty() && !library_missing_) {
            warn(fmt::format(
                "material '{}' is not defined{}: its faces are grey", printable(*undefined.begin()),
                undefined.size() == 1
                    ? ""
                    : fmt::format(", nor {} {} more", undefined.size() == 2 ? "is" : "are", undefined.size() - 1)));
        }
        if (dropped != 0) {
            warn(fmt::format("{} without an area {} left out",
                             dropped == 1 ? "1 face" : fmt::format("{} faces", dropped), dropped == 1 ? "is" : "are"));
        }
    }

    void set_normals(Model& out, std::span<const std::array<std::uint32_t, 3>> triangles,
                     std::span<const std::array<std::int64_t, 3>> normals, std::span<const Vec3> areas) const {
        std::vector<std::size_t> without;
        for (std::size_t c = 0; c < 3 * out.triangles.size(); ++c) {
            const std::int64_t given = normals[c / 3][c % 3];
            const Vec3 normal = given < 0 ? Vec3{} : direction(normals_[static_cast<std::size_t>(given)]);
            out.triangles[c / 3].corners[c % 3].normal = normal;
            if (normal == Vec3{}) without.push_back(c);
        }
        if (without.empty()) return;
        const Smoothing smoothing(triangles, areas, vertices_.size());
        for (const std::size_t c : without) {
            out.triangles[c / 3].corners[c % 3].normal = smoothing.normal(c / 3, c % 3);
        }
    }

    static constexpr std::int64_t most_index = std::int64_t{1} << 62;

    const std::string& file_;
    const FindFile& find_;
    std::vector<std::string>& warnings_;
    Line line_;
    std::vector<Vec3> vertices_, normals_, colours_;  // no colours where no vertex has one
    double brightest_ = 0.0;
    double darkest_ = 0.0;
    std::vector<FaceCorner> corners_;
    std::vector<Face> faces_;
    std::vector<std::string> names_;
    std::unordered_map<std::string, std::uint32_t> name_numbers_;
    std::uint32_t name_ = no_name;
    std::vector<Material> materials_;
    std::set<std::filesystem::path> libraries_;
    bool library_missing_ = false;
    Seen unknown_, not_drawn_;
};

/// The file beside a model that its text means: with either slash, in either case, and, where the folder that is named
/// is one of another machine, in the model's own.
std::filesystem::path find_beside(const std::filesystem::path& folder, std::string name) {
    std::error_code unknown;
    const auto there = [&](const std::filesystem::path& path) {
        return std::filesystem::is_regular_file(path, unknown);
    };
    if (there(folder / name)) return folder / name;
    std::replace(name.begin(), name.end(), '\\', '/');
    if (there(folder / name)) return folder / name;
    const std::string last = lower(std::filesystem::path(name).filename().string());
    for (const std::filesystem::path& in : {(folder / name).parent_path(), folder}) {
        std::vector<std::filesystem::path> found;
        for (std::filesystem::directory_iterator at(in.empty() ? "." : in, unknown), end; at != end;
             at.increment(unknown)) {
            if (lower(at->path().filename().string()) == last && there(at->path())) found.push_back(at->path());
        }
        if (!found.empty()) return *std::min_element(found.begin(), found.end());
    }
    return {};
}

}  // namespace

Model parse_obj(std::string_view text, const std::string& file, const FindFile& find,
                std::vector<std::string>& warnings) {
    return ObjReader(file, find, warnings).read(text);
}

Model read_obj(const std::filesystem::path& path, std::vector<std::string>& warnings) {
    const auto find = [&](const std::string& name) { return find_beside(path.parent_path(), name); };
    Model out = parse_obj(read_file(path), path.string(), find, warnings);
    out.files.push_back(path);
    return out;
}

}  // namespace glint::render
