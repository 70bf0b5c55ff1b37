#include "scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "glint/error.hpp"
#include "glint/lobes.hpp"
#include "models.hpp"
#include "text.hpp"
#include "wavefront.hpp"

namespace glint::render {
namespace {

using Json = nlohmann::json;

constexpr double below_16 = 15.999;  // what the ports of a light's colour carry
constexpr double most_intense = 1e6;
constexpr double farthest = 1e12;  // what an OBJ file may hold

/// A part of the scene file with its name for messages, such as "still_life.json: lights[2]".
class Part {
public:
    /// Throws Error unless it is an object and all its keys are among `legal`.
    Part(const Json& json, std::string where, const std::set<std::string>& legal)
        : json_(json), where_(std::move(where)) {
        std::string list;
        for (const std::string& key : legal) list += (list.empty() ? "" : ", ") + key;
        if (!json.is_object()) throw Error(fmt::format("{} is not legal: an object with {}", where_, list));
        for (const auto& item : json.items()) {
            if (!legal.contains(item.key())) {
                throw Error(fmt::format("{}: key '{}' is not known: {}", where_, printable(item.key()), list));
            }
        }
    }

    const std::string& where() const { return where_; }
    bool has(const std::string& key) const { return json_.contains(key); }
    const Json& at(const std::string& key) const { return json_.at(key); }

    std::string text(const std::string& key) const {
        if (!at(key).is_string()) refuse(key, "a text");
        const auto& text = at(key).get_ref<const std::string&>();
        if (text.find('\0') != text.npos) refuse(key, "a text without the character 0");
        return text;
    }
    double number(const std::string& key, double otherwise, double low, double high) const {
        return has(key) ? number(at(key), key, low, high) : otherwise;
    }
    Vec3 vector(const std::string& key, const Vec3& otherwise, double low, double high) const {
        if (!has(key)) return otherwise;
        const Json& value = at(key);
        if (!value.is_array() || value.size() != 3) refuse(key, "three numbers");
        return {number(value[0], key, low, high), number(value[1], key, low, high), number(value[2], key, low, high)};
    }
    [[noreturn]] void refuse(const std::string& key, const std::string& legal) const {
        throw Error(fmt::format("{}: {} {} is not legal: {}", where_, key, printable(at(key).dump()), legal));
    }

private:
    double number(const Json& value, const std::string& key, double low, double high) const {
        const double x = value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
        if (!(x >= low && x <= high)) refuse(key, fmt::format("numbers from {:g} to {:g}", low, high));
        return x;
    }

    const Json& json_;
    std::string where_;
};

/// What a scene file says of a material, over what an MTL file says or over a black one.
void change(Material& material, const Json& json, const std::string& where, std::vector<std::string>& warnings) {
    const Part part(json, where, {"Ka", "Kd", "Ks", "Ns", "Pr", "aniso", "Ni", "brdf", "lobe"});
    material.ambient = part.vector("Ka", material.ambient, 0.0, 1.0);
    material.diffuse = part.vector("Kd", material.diffuse, 0.0, 1.0);
    material.specular = part.vector("Ks", material.specular, 0.0, 1.0);
    if (part.has("Ns")) material.exponent = exponent(part.number("Ns", 0, 0, 1e9), material.name, warnings);
    material.roughness = part.number("Pr", material.roughness, 0.0, 1.0);
    material.anisotropy = part.number("aniso", material.anisotropy, 0.0, 0.99);
    material.index = part.number("Ni", material.index, 1.0, 10.0);
    set_models(material, part.has("brdf") ? part.text("brdf") : material.diffuse_model + ' ' + material.specular_model,
               where);
    if (part.has("lobe")) {
        material.lobe = part.text("lobe");
        parse_lobe(material.lobe);  // refuses what is not known
    }
}

struct Placing {
    double scale = 1.0;
    double sine = 0.0;
    double cosine = 1.0;  // of the turn about the y axis
    Vec3 translate;

    Vec3 turned(const Vec3& v) const { return {cosine * v.x + sine * v.z, v.y, cosine * v.z - sine * v.x}; }
    Corner operator()(const Corner& corner) const {
        return {scale * turned(corner.position) + translate, turned(corner.normal), corner.colour};
    }
};

Camera look_at(const Vec3& eye, const Vec3& target, const Vec3& up, double degrees, const std::string& where) {
    Camera out;
    out.eye = eye;
    out.forward = direction(target - eye);
    out.right = direction(cross(out.forward, up));
    out.up = cross(out.right, out.forward);
    out.tangent = std::tan(degrees * std::numbers::pi / 360.0);
    if (out.right == Vec3{}) {
        throw Error(fmt::format("{}: the camera has no direction: eye, target and up lie on one line", where));
    }
    return out;
}

/// Makes a box hold a point.
void extend(Vec3& low, Vec3& high, const Vec3& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
}

/// From the front, a little from the right and from above, as near as the whole model is in the picture, with a margin.
Camera framing(const std::vector<Triangle>& triangles, double aspect) {
    constexpr double degrees = 35.0;
    constexpr double margin = 0.9;
    Vec3 low = triangles.front().corners.front().position;
    Vec3 high = low;
    for (const Triangle& triangle : triangles) {
        for (const Corner& corner : triangle.corners) {
            extend(low, high, corner.position);
        }
    }
    const Vec3 centre = 0.5 * (low + high);
    const double radius = 0.5 * length(high - low);
    Camera camera = look_at(centre + radius * direction({0.45, 0.35, 1.0}), centre, {0, 1, 0}, degrees, "model");
    double distance = 0.0;
    for (const Triangle& triangle : triangles) {
        for (const Corner& corner : triangle.corners) {
            const Vec3 p = corner.position - centre;
            const double across = std::max(std::abs(dot(p, camera.right)) / aspect, std::abs(dot(p, camera.up)));
            distance = std::max(distance, across / (margin * camera.tangent) - dot(p, camera.forward));
        }
    }
    camera.eye = centre - distance * camera.forward;
    return camera;
}

/// A key light over the left shoulder and a weaker, cooler fill light from the right.
std::vector<Light> key_and_fill(const Camera& camera) {
    const auto from = [&](double right, double up, double back) {
        return direction(right * camera.right + up * camera.up - back * camera.forward);
    };
    return {{true, from(-0.6, 0.8, 1.0), {0.95, 0.92, 0.86}}, {true, from(1.0, 0.15, 0.7), {0.22, 0.26, 0.32}}};
}

Light read_light(const Json& json, const std::string& where) {
    const Part part(json, where, {"position", "direction", "colour", "intensity", "attenuation"});
    if (part.has("position") == part.has("direction")) {
        throw Error(fmt::format("{} is not legal: a light has either a position or a direction", where));
    }
    Light out;
    out.directional = part.has("direction");
    out.place = part.vector(out.directional ? "direction" : "position", {}, -farthest, farthest);
    if (out.directional) {
        out.place = direction(-out.place);  // the file says where the light goes
        if (out.place == Vec3{}) part.refuse("direction", "a direction other than 0 0 0");
    }
    const double intensity = part.number("intensity", 1.0, 0.0, most_intense);
    out.colour = intensity * part.vector("colour", {1, 1, 1}, 0.0, below_16);
    out.attenuation = part.vector("attenuation", {1, 0, 0}, 0.0, most_intense);
    if (out.attenuation == Vec3{}) part.refuse("attenuation", "three numbers that are not all 0");
    if (out.directional && part.has("attenuation")) part.refuse("attenuation", "none for a light without a position");
    return out;
}

void read_background(Scene& scene, const Json& json, const std::string& file) {
    if (json.is_array()) {
        const Json whole{{"background", json}};
        scene.background_top = scene.background_bottom =
            Part(whole, file, {"background"}).vector("background", {}, 0.0, 1.0);
        return;
    }
    const Part part(json, file + ": background", {"bottom", "top"});
    scene.background_top = part.vector("top", {}, 0.0, 1.0);
    scene.background_bottom = part.vector("bottom", {}, 0.0, 1.0);
}

/// Moves the scene so that its middle is near 0, by whole multiples of a power of two about as large as the scene: what
/// comes after in single precision keeps its digits, and a scene around 0 stays as it is.
void move_to_middle(Scene& scene) {
    Vec3 low = scene.triangles.front().corners.front().position;
    Vec3 high = low;
    for (const Triangle& triangle : scene.triangles) {
        for (const Corner& corner : triangle.corners) extend(low, high, corner.position);
    }
    const Vec3 extent = high - low;
    const double step = std::ldexp(1.0, 2 + std::ilogb(std::max({extent.x, extent.y, extent.z})));
    const auto whole = [&](double a, double b) { return step * std::round((0.5 * a + 0.5 * b) / step); };
    const Vec3 middle{whole(low.x, high.x), whole(low.y, high.y), whole(low.z, high.z)};
    if (middle == Vec3{}) return;
    for (Triangle& triangle : scene.triangles) {
        for (Corner& corner : triangle.corners) corner.position = corner.position - middle;
    }
    for (Light& light : scene.lights) {
        if (!light.directional) light.place = light.place - middle;
    }
    scene.camera.eye = scene.camera.eye - middle;
}

/// The objects of a scene file: models read once each, placed as often as they are named.
class Builder {
public:
    Builder(Scene& scene, std::filesystem::path folder, const Json& materials, std::string file)
        : scene_(scene), folder_(std::move(folder)), changes_(materials), file_(std::move(file)) {
        for (const auto& item : changes_.items()) {
            Material material;
            material.name = item.key();
            change(material, item.value(), where(item.key()), scene_.warnings);
            own_[item.key()] = add(std::move(material));
        }
    }

    void place(const Json& json, const std::string& where) {
        const Part part(json, where, {"file", "material", "scale", "turn", "translate"});
        if (!part.has("file")) throw Error(fmt::format("{}: key 'file' is missing", where));
        const Loaded& loaded = load(part.text("file"));
        Placing placing;
        placing.scale = part.number("scale", 1.0, 1e-6, 1e6);
        const double turn = part.number("turn", 0.0, -360.0, 360.0) * std::numbers::pi / 180.0;
        placing.sine = std::sin(turn);
        placing.cosine = std::cos(turn);
        placing.translate = part.vector("translate", {}, -farthest, farthest);
        const bool whole = part.has("material");
        std::uint32_t material = 0;
        if (whole) {
            const auto found = own_.find(part.text("material"));
            if (found == own_.end()) part.refuse("material", "a name under 'materials' of the scene file");
            material = found->second;
        }
        for (Triangle triangle : loaded.model.triangles) {
            for (Corner& corner : triangle.corners) corner = placing(corner);
            triangle.material = whole ? material : loaded.first + triangle.material;
            scene_.triangles.push_back(triangle);
        }
    }

private:
    struct Loaded {
        Model model;
        std::uint32_t first = 0;  // of its materials in the scene's
    };

    std::string where(const std::string& material) const { return fmt::format("{}: materials '{}'", file_, material); }

    std::uint32_t add(Material material) {
        scene_.materials.push_back(std::move(material));
        return static_cast<std::uint32_t>(scene_.materials.size() - 1);
    }

    const Loaded& load(const std::string& name) {
        const auto known = loaded_.find(name);
        if (known != loaded_.end()) return known->second;
        Loaded& out = loaded_[name];
        out.model = read_obj(folder_ / name, scene_.warnings);
        scene_.files.insert(scene_.files.end(), out.model.files.begin(), out.model.files.end());
        out.first = static_cast<std::uint32_t>(scene_.materials.size());
        for (Material material : out.model.materials) {
            if (changes_.contains(material.name)) {
                std::vector<std::string> told;  // when the material was made from the same keys
                change(material, changes_.at(material.name), where(material.name), told);
            }
            add(std::move(material));
        }
        return out;
    }

    Scene& scene_;
    std::filesystem::path folder_;
    Json changes_;
    std::string file_;
    std::map<std::string, std::uint32_t> own_;
    std::map<std::string, Loaded> loaded_;
};

/// Looks through a JSON text for what cannot be read into a document: its own nesting, numbers that are no double, keys
/// that a second value would hide.
class Inspector final : public Json::json_sax_t {
public:
    explicit Inspector(std::string file) : file_(std::move(file)) {}

    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool string(string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    bool start_object(std::size_t) override { return open(); }
    bool start_array(std::size_t) override { return open(); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(string_t& name) override {
        levels_.back().now = name;
        if (levels_.back().seen.insert(name).second) return true;
        throw Error(fmt::format("{}: key '{}' is there twice", file_, printable(name)));
    }
    bool parse_error(std::size_t, const std::string& token, const Json::exception& error) override {
        if (dynamic_cast<const Json::out_of_range*>(&error) != nullptr) {
            std::string path;
            for (const Level& level : levels_) path += level.now.empty() ? "" : printable(level.now) + ' ';
            throw Error(fmt::format("{}: {}{} is not legal: numbers up to {:g}", file_, path, printable(token),
                                    std::numeric_limits<double>::max()));
        }
        const std::string_view what = error.what();
        throw Error(fmt::format("{} is not JSON: {}", file_, printable(what.substr(what.find("parse error")), 200)));
    }

private:
    struct Level {
        std::string now;
        std::set<std::string> seen;
    };

    bool open() {
        constexpr std::size_t deepest = 16;
        if (levels_.size() == deepest) {
            throw Error(fmt::format("{} is not legal: lists and objects are nested in more than {}", file_, deepest));
        }
        levels_.emplace_back();
        return true;
    }
    bool close() {
        levels_.pop_back();
        return true;
    }

    std::string file_;
    std::vector<Level> levels_;
};

Json parse_json(const std::string& text, const std::string& file) {
    check_text(text, file);
    Inspector inspector(file);
    Json::sax_parse(text, &inspector);
    return Json::parse(text);
}

}  // namespace

Scene parse_scene(const std::string& text, const std::filesystem::path& path, double aspect) {
    const std::string file = path.string();
    const Json json = parse_json(text, file);
    const Part part(json, file, {"about", "objects", "materials", "lights", "ambient", "background", "camera"});
    Scene scene;
    const Json materials = part.has("materials") ? part.at("materials") : Json::object();
    if (!materials.is_object()) part.refuse("materials", "an object of names");
    if (!part.has("objects") || !part.at("objects").is_array() || part.at("objects").empty()) {
        throw Error(fmt::format("{}: 'objects' is missing or empty: a list of objects with a file each", file));
    }
    Builder builder(scene, path.parent_path(), materials, file);
    for (std::size_t i = 0; i < part.at("objects").size(); ++i) {
        builder.place(part.at("objects")[i], fmt::format("{}: objects[{}]", file, i));
    }
    scene.ambient = part.vector("ambient", scene.ambient, 0.0, below_16);
    if (part.has("background")) read_background(scene, part.at("background"), file);
    if (part.has("camera")) {
        const Part camera(part.at("camera"), file + ": camera", {"eye", "target", "up", "fov"});
        if (!camera.has("eye") || !camera.has("target")) {
            throw Error(fmt::format("{}: eye or target is missing", camera.where()));
        }
        scene.camera =
            look_at(camera.vector("eye", {}, -farthest, farthest), camera.vector("target", {}, -farthest, farthest),
                    camera.vector("up", {0, 1, 0}, -farthest, farthest), camera.number("fov", 35.0, 1.0, 150.0),
                    camera.where());
    } else {
        scene.camera = framing(scene.triangles, aspect);
    }
    if (part.has("lights")) {
        constexpr std::size_t most_lights = 256;
        const Json& lights = part.at("lights");
        if (!lights.is_array() || lights.size() > most_lights) {
            throw Error(fmt::format("{}: lights is not legal: a list of at most {}", file, most_lights));
        }
        for (std::size_t i = 0; i < lights.size(); ++i) {
            scene.lights.push_back(read_light(lights[i], fmt::format("{}: lights[{}]", file, i)));
        }
    } else {
        scene.lights = key_and_fill(scene.camera);
    }
    warn_of_limits(scene.materials, scene.warnings);
    move_to_middle(scene);
    return scene;
}

Scene load_scene(const std::filesystem::path& path, double aspect) {
    const std::string extension = lower(path.extension().string());
    if (extension == ".json") return parse_scene(read_file(path), path, aspect);
    if (extension != ".obj") {
        throw Error(fmt::format("scene '{}' is not legal: a file NAME.json or NAME.obj", path.string()));
    }
    Scene scene;
    Model model = read_obj(path, scene.warnings);
    scene.materials = std::move(model.materials);
    scene.triangles = std::move(model.triangles);
    scene.files = std::move(model.files);
    scene.background_top = {0.16, 0.19, 0.24};
    scene.background_bottom = {0.05, 0.055, 0.065};
    scene.camera = framing(scene.triangles, aspect);
    scene.lights = key_and_fill(scene.camera);
    warn_of_limits(scene.materials, scene.warnings);
    move_to_middle(scene);
    return scene;
}

}  // namespace glint::render
