#include "wavefront.hpp"

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "catch.hpp"
#include "glint/error.hpp"
#include "models.hpp"

using namespace glint;
using namespace glint::render;

namespace {

struct Read {
    Material material;
    std::vector<std::string> warnings;
};

/// The one material of an MTL text.
Read mtl(const std::string& lines) {
    Read out;
    const std::vector<Material> all = read_mtl("newmtl m\n" + lines, "test.mtl", out.warnings);
    REQUIRE(all.size() == 1);
    out.material = all.front();
    return out;
}

std::string refusal(const std::string& lines) {
    std::vector<std::string> warnings;
    try {
        read_mtl("newmtl m\n" + lines, "test.mtl", warnings);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

const std::string colours = "Ka 0.1 0.2 0.3\nKd 0.4 0.5 0.6\nKs 0.7 0.8 0.9\n";

/// A file in a folder of its own, gone at the end.
class File {
public:
    explicit File(const std::string& text)
        : path_(std::filesystem::temp_directory_path() / ("glint_render_test_" + std::to_string(getpid()) + ".obj")) {
        std::ofstream(path_) << text;
    }
    ~File() { std::filesystem::remove(path_); }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

std::string obj_refusal(const std::string& text) {
    const File file(text);
    std::vector<std::string> warnings;
    try {
        read_obj(file.path(), warnings);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("mtl: Ns is the exponent, halves away from zero, cut to 1 .. 1023 with one warning") {
    struct Case {
        std::string ns;
        int n;
        std::size_t warnings;
    };
    for (const Case& c : {Case{"1", 1, 0},
                          {"0", 1, 1},
                          {"0.4", 1, 1},
                          {"0.5", 1, 0},
                          {"2.5", 3, 0},
                          {"49.49", 49, 0},
                          {"49.5", 50, 0},
                          {"1000", 1000, 0},
                          {"1023.4", 1023, 0},
                          {"1023.5", 1023, 1},
                          {"100000", 1023, 1},
                          {"-3", 1, 1}}) {
        const Read read = mtl(colours + "illum 2\nNs " + c.ns + "\n");
        INFO("Ns " << c.ns);
        CHECK(read.material.exponent == c.n);
        CHECK(read.warnings.size() == c.warnings);
    }
    // Without a highlight the exponent does not matter, and nobody is warned.
    CHECK(mtl("Kd 1 1 1\nNs 0\n").warnings.empty());
}

TEST_CASE("mtl: illum says what is on") {
    const Material none = mtl(colours + "illum 0\n").material;
    CHECK(none.emission.x == Approx(0.4));
    CHECK(none.ambient == Vec3{});
    CHECK(none.diffuse == Vec3{});
    CHECK(none.diffuse_model.empty());
    CHECK(none.specular_model.empty());
    const Material matte = mtl(colours + "illum 1\n").material;
    CHECK(matte.emission == Vec3{});
    CHECK(matte.ambient.y == Approx(0.2));
    CHECK(matte.diffuse_model == "lambert");
    CHECK(matte.specular_model.empty());
    for (const std::string illum : {"", "illum 2\n"}) {
        const Read read = mtl(colours + illum);
        CHECK(read.material.diffuse_model == "lambert");
        CHECK(read.material.specular_model == "blinn_phong");
        CHECK(read.warnings.empty());
    }
    for (int illum = 3; illum <= 10; ++illum) {
        const Read read = mtl(colours + "illum " + std::to_string(illum) + "\n");
        CHECK(read.material.specular_model == "blinn_phong");
        REQUIRE(read.warnings.size() == 1);
        CHECK(holds(read.warnings[0], "reflection, refraction or shadows"));
    }
    for (const std::string illum : {"11", "-1", "1.5"}) {
        CHECK(holds(refusal("illum " + illum), "test.mtl:2: illum '" + illum + "' is not legal: 0 to 10"));
    }
}

TEST_CASE("mtl: colours of zero remove the effect") {
    CHECK(mtl("Ka 1 1 1\nKd 0 0 0\nKs 1 1 1\nNs 5\n").material.diffuse_model.empty());
    CHECK(mtl("Ka 1 1 1\nKd 1 1 1\nKs 0 0 0\nNs 5\n").material.specular_model.empty());
    CHECK(mtl("Ka 0 0 0\nKd 1 1 1\n").material.ambient == Vec3{});
    CHECK(mtl("Kd 0 0 0\nKs 0 0 0\nbrdf lambert phong\n").material.specular_model.empty());
}

TEST_CASE("mtl: colours of one number, and outside 0 .. 1") {
    CHECK(mtl("Kd 0.5\n").material.diffuse == Vec3{0.5, 0.5, 0.5});
    const Read read = mtl("Kd 1.5 0.5 -2\n");
    CHECK(read.material.diffuse == Vec3{1, 0.5, 0});
    REQUIRE(read.warnings.size() == 1);
    CHECK(holds(read.warnings[0], "Kd 1.5 0.5 -2 is cut to 0 .. 1"));
}

TEST_CASE("mtl: brdf picks the models") {
    CHECK(mtl(colours + "brdf phong\n").material.specular_model == "phong");
    CHECK(mtl(colours + "brdf phong\n").material.diffuse_model == "lambert");
    CHECK(mtl(colours + "brdf blinn_phong\n").material.specular_model == "blinn_phong");
    CHECK(mtl(colours + "brdf lambert phong\n").material.specular_model == "phong");
    CHECK(holds(refusal(colours + "brdf gouraud\n"),
                "material 'm': brdf 'gouraud' is not known: lambert, phong, blinn_phong"));
    CHECK(holds(refusal(colours + "brdf phong blinn_phong\n"), "a material has one specular model"));
    for (const LightingModel& model : lighting_models()) {
        const Material material =
            mtl(colours + "Pr 0.4\naniso 0.2\nNi 1.6\nbrdf " + std::string(model.name) + "\n").material;
        CHECK((model.diffuse ? material.diffuse_model : material.specular_model) == model.name);
        // What feeds the model's ports is there, a finite number each.
        const auto golden = find_effect(model.name).golden(parse_profile("p12"), "bps");
        std::size_t ports = 0;
        for (const EffectPort& port : golden->inputs()) ports += port.kind == EffectPort::Kind::parameter ? 1 : 0;
        const std::vector<double> parameters = model.parameters(material);
        CHECK(parameters.size() == ports);
        for (const double x : parameters) CHECK(std::isfinite(x));
    }
}

TEST_CASE("mtl: roughness, anisotropy, index") {
    const Material material = mtl(colours + "Pr 0.25\naniso 0.5\nNi 1.75\n").material;
    CHECK(material.roughness == Approx(0.25));
    CHECK(material.anisotropy == Approx(0.5));
    CHECK(material.index == Approx(1.75));
    CHECK(mtl(colours).material.index == Approx(1.5));
    CHECK(mtl(colours + "Ni 0\n").material.index == Approx(1.0));
    CHECK(holds(refusal("Pr 1.5"), "Pr 1.5 is not legal: 0 to 1"));
    CHECK(holds(refusal("Ni 11"), "Ni 11 is not legal: 0 to 10"));
}

TEST_CASE("mtl: what a model cannot take counts as the nearest that it can, with a warning") {
    struct Case {
        std::string lines;
        std::size_t warnings;
    };
    for (const Case& c : {Case{"Pr 0.01\nbrdf ward\n", 1},
                          {"Pr 0.02\nbrdf ward\n", 0},
                          {"Pr 0.04\nbrdf cook_torrance\n", 1},
                          {"Pr 0.05\nNi 4\nbrdf cook_torrance_modified\n", 0},
                          {"Pr 0\nNi 5\nbrdf cook_torrance\n", 2},
                          {"Pr 0\nNi 9\nbrdf oren_nayar phong\n", 0},
                          {"Pr 1\naniso 0.99\nbrdf ward\n", 0}}) {
        INFO(c.lines);
        const Material material = mtl(colours + c.lines).material;
        std::vector<std::string> warnings;
        warn_of_limits({material}, warnings);
        CHECK(warnings.size() == c.warnings);
        for (const double x : find_model(material.specular_model)->parameters(material)) CHECK(std::isfinite(x));
    }
}

TEST_CASE("mtl: what is no finite number is refused with its line") {
    for (const std::string number : {"nan", "inf", "-inf", "1e400", "abc", "1,5", ""}) {
        INFO("'" << number << "'");
        CHECK(holds(refusal("Kd 0.5 0.5 0.5\nNs " + number + "\n"), "test.mtl:3: "));
        CHECK(holds(refusal("Ks 1 1 " + number + "\n"), "test.mtl:2: "));
    }
}

TEST_CASE("obj: NaN, vertices that are not there, nothing to see") {
    CHECK(holds(obj_refusal("v 0 0 0\nv 1 0 nan\nv 0 1 0\nf 1 2 3\n"), ".obj:2: 'nan' is not legal"));
    CHECK(
        holds(obj_refusal("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 inf 0\nf 1//1 2//1 3//1\n"), ".obj:4: 'inf' is not legal"));
    CHECK(holds(obj_refusal("v 0 0 0\nv 1 0\nv 0 1 0\nf 1 2 3\n"), "has 2 numbers"));
    CHECK(holds(obj_refusal("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"), "a face asks for vertex 9, there are 3"));
    CHECK(holds(obj_refusal("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//7\n"), "normal 7, there are 1"));
    CHECK(holds(obj_refusal(""), "there are no faces with an area"));
    CHECK(holds(obj_refusal("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), "there are no faces with an area"));
}

TEST_CASE("obj: degenerate triangles are left out, with a warning") {
    const File file("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\nf 1 2 4\nf 1 1 2\n");
    std::vector<std::string> warnings;
    const Model model = read_obj(file.path(), warnings);
    CHECK(model.triangles.size() == 1);
    REQUIRE(warnings.size() == 1);
    CHECK(holds(warnings[0], "2 faces without an area are left out"));
}

TEST_CASE("obj: missing normals are those of the faces around, up to an edge of 60 degrees") {
    // A roof: two faces that meet at a right angle, and one that continues the second in its plane.
    const File file("v 0 0 0\nv 0 0 1\nv -1 -1 0\nv 1 -1 0\nv 2 -2 1\nf 1 3 2\nf 1 2 4\nf 2 5 4\n");
    std::vector<std::string> warnings;
    const Model model = read_obj(file.path(), warnings);
    REQUIRE(model.triangles.size() == 3);
    const double h = std::sqrt(0.5);
    for (const Corner& corner : model.triangles[0].corners) {
        CHECK(std::abs(corner.normal.x) == Approx(h));
        CHECK(corner.normal.z == Approx(0.0).margin(1e-9));
    }
    CHECK(dot(model.triangles[0].corners[0].normal, model.triangles[1].corners[0].normal) == Approx(0.0).margin(1e-9));
    // A bend of 30 degrees is smoothed.
    const File bent("v 0 0 0\nv 0 0 1\nv -1 0 0\nv 0.866 -0.5 0\nf 1 3 2\nf 1 2 4\n");
    const Model smooth = read_obj(bent.path(), warnings);
    REQUIRE(smooth.triangles.size() == 2);
    CHECK(dot(smooth.triangles[0].corners[0].normal, smooth.triangles[1].corners[0].normal) == Approx(1.0));
    CHECK(dot(smooth.triangles[0].corners[1].normal, smooth.triangles[1].corners[2].normal) < 0.9);
}

TEST_CASE("obj: normals of length 0 and other than 1") {
    const File file("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nvn 0 0 5\nvn 0 3 4\nf 1//1 2//2 3//3\n");
    std::vector<std::string> warnings;
    const Model model = read_obj(file.path(), warnings);
    REQUIRE(model.triangles.size() == 1);
    CHECK(model.triangles[0].corners[0].normal == Vec3{0, 0, 1});  // the face's own
    CHECK(model.triangles[0].corners[1].normal == Vec3{0, 0, 1});
    CHECK(model.triangles[0].corners[2].normal.y == Approx(0.6));
}
