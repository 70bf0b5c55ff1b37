#include "wavefront.hpp"

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "catch.hpp"
#include "models.hpp"
#include "refusal.hpp"

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

std::string mtl_refusal(const std::string& lines) {
    std::vector<std::string> warnings;
    return refusal([&] { read_mtl("newmtl m\n" + lines, "test.mtl", warnings); });
}

const std::string colours = "Ka 0.1 0.2 0.3\nKd 0.4 0.5 0.6\nKs 0.7 0.8 0.9\n";

/// A folder of its own, gone at the end.
class Folder {
public:
    Folder() : path_(std::filesystem::temp_directory_path() / ("glint_render_test_" + std::to_string(getpid()))) {
        std::filesystem::create_directory(path_);
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    const std::filesystem::path& path() const { return path_; }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(path_ / name, std::ios::binary) << text;
    }

private:
    std::filesystem::path path_;
};

struct ReadModel {
    Model model;
    std::vector<std::string> warnings;
};

/// A text as the file "test.obj", which finds no other file.
ReadModel obj(const std::string& text) {
    ReadModel out;
    out.model = parse_obj(
        text, "test.obj", [](const std::string&) { return std::filesystem::path(); }, out.warnings);
    return out;
}

std::string obj_refusal(const std::string& text) {
    return refusal([&] { obj(text); });
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
        const Read read = mtl(colours + "illum " + illum + "\n");
        CHECK(read.material.specular_model == "blinn_phong");
        REQUIRE(read.warnings.size() == 1);
        CHECK(holds(read.warnings[0], "illum " + illum + " is not known and counts as 2"));
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
    CHECK(holds(mtl_refusal(colours + "brdf gouraud\n"),
                "material 'm': brdf 'gouraud' is not known: lambert, phong, blinn_phong"));
    CHECK(holds(mtl_refusal(colours + "brdf phong blinn_phong\n"), "a material has one specular model"));
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
}

TEST_CASE("mtl: what is out of range counts as the nearest value, what is missing as not given, with one warning") {
    struct Case {
        std::string line, warning;
        double roughness = 0.3, anisotropy = 0.0, index = 1.5;
        int exponent = 1;
    };
    for (const Case& c :
         {Case{"Pr 1.2", "Pr 1.2 counts as 1", 1.0}, Case{"Pr -1", "Pr -1 counts as 0", 0.0},
          Case{"aniso 1", "aniso 1 counts as 0.99", 0.3, 0.99}, Case{"Ni 25", "Ni 25 counts as 10", 0.3, 0.0, 10.0},
          Case{"Ns", "test.mtl:5: Ns has no number and counts as not given"},
          Case{"Ns # none", "test.mtl:5: Ns has no number"},
          Case{"Ns 7 8", "Ns has 2 numbers, the first 1 of which count", 0.3, 0.0, 1.5, 7}}) {
        INFO(c.line);
        const Read read = mtl(colours + c.line + "\n");
        CHECK(read.material.roughness == c.roughness);
        CHECK(read.material.anisotropy == c.anisotropy);
        CHECK(read.material.index == c.index);
        CHECK(read.material.exponent == c.exponent);
        REQUIRE(read.warnings.size() == 1);
        CHECK(holds(read.warnings[0], c.warning));
    }
    CHECK(mtl("Kd 1 0.5 0.25 1\n").material.diffuse == Vec3{1, 0.5, 0.25});
}

TEST_CASE("mtl: a diffuse colour where one is meant but missing") {
    const Vec3 usual{0.8, 0.8, 0.8};
    for (const std::string lines : {"map_Kd wood.png\n", "Ka 1 1 1\nKs 0 0 0\nmap_Kd -s 2 2 wood.png\n", "Ns 4\n",
                                    "Kd spectral file.rfl 1\n", "Kd xyz 0.2 0.3 0.4\n"}) {
        INFO(lines);
        const Read read = mtl(lines);
        CHECK(read.material.diffuse == usual);
        CHECK(read.warnings.size() == (lines.starts_with("Ns") ? 1 : 2));
    }
    CHECK(mtl("Kd 0 0 0\nmap_Kd wood.png\n").material.diffuse == Vec3{});
    CHECK(mtl("Ks 1 1 1\nNs 5\n").material.diffuse == Vec3{});
}

TEST_CASE("mtl: names, comments, line ends, byte order mark") {
    const auto names = [](const std::string& text) {
        std::vector<std::string> warnings, out;
        for (const Material& material : read_mtl(text, "test.mtl", warnings)) out.push_back(material.name);
        return out;
    };
    using Names = std::vector<std::string>;
    CHECK(names("newmtl red # the roof\nKd 1 0 0\n") == Names{"red"});
    CHECK(names("newmtl Material #25\nnewmtl a b  c \t\n") == Names{"Material #25", "a b  c"});
    CHECK(names("newmtl #1\nnewmtl #2 # c\nnewmtl # c\n") == Names{"#1", "#2", ""});
    CHECK(names("newmtl red\\\nKd 1 0 0\n") == Names{"red\\"});
    CHECK(names("\xef\xbb\xbfnewmtl red\rKd 1 0 0\rnewmtl blue\r\nKd 0 0 1") == Names{"red", "blue"});
    CHECK(names("newmtl\nKd 1 0 0\n") == Names{""});
    CHECK(mtl("Kd 0.25 \\\n 0.5 \\ \r\n 1\n").material.diffuse == Vec3{0.25, 0.5, 1});
    std::vector<std::string> warnings;
    CHECK(read_mtl("Kd 1 1 1\nNs 3\nnewmtl a\nKd 1 1 1\n", "test.mtl", warnings).size() == 1);
    REQUIRE(warnings.size() == 1);
    CHECK(holds(warnings[0], "test.mtl:1: 'Kd' before the first newmtl is left out"));
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
    for (const std::string number : {"nan", "inf", "-inf", "1e400", "abc", "1,5", "0x10", "++1", "1e"}) {
        INFO("'" << number << "'");
        CHECK(holds(mtl_refusal("Kd 0.5 0.5 0.5\nNs " + number + "\n"), "test.mtl:3: "));
        CHECK(holds(mtl_refusal("Ks 1 1 " + number + "\n"), "test.mtl:2: "));
    }
    CHECK(holds(mtl_refusal("Ks 1 1\n"), "test.mtl:2: 'Ks' has 2 numbers, legal are 1 or 3"));
    CHECK(holds(mtl_refusal(std::string("K\0", 2)), "test.mtl: byte 10 is 0"));
    CHECK(mtl("Kd 1e-400 +.5 5.e-1\n").material.diffuse == Vec3{0, 0.5, 0.5});
}

TEST_CASE("obj: NaN, vertices that are not there, nothing to see") {
    CHECK(holds(obj_refusal("v 0 0 0\nv 1 0 nan\nv 0 1 0\nf 1 2 3\n"), ".obj:2: 'nan' is not legal"));
    CHECK(
        holds(obj_refusal("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 inf 0\nf 1//1 2//1 3//1\n"), ".obj:4: 'inf' is not legal"));
    CHECK(holds(obj_refusal("v 0 0 0\nv 1 0\nv 0 1 0\nf 1 2 3\n"), "has 2 numbers"));
    CHECK(holds(obj_refusal("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"), "a face asks for vertex 9, there are 3"));
    CHECK(holds(obj_refusal(""), "there are no faces with an area"));
    CHECK(holds(obj_refusal("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), "there are no faces with an area"));
}

TEST_CASE("obj: degenerate triangles are left out, with a warning") {
    const auto [model, warnings] = obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\nf 1 2 4\nf 1 1 2\n");
    CHECK(model.triangles.size() == 1);
    REQUIRE(warnings.size() == 1);
    CHECK(holds(warnings[0], "2 faces without an area are left out"));
}

TEST_CASE("obj: missing normals are those of the faces around, up to an edge of 60 degrees") {
    // A roof: two faces that meet at a right angle, and one that continues the second in its plane.
    const auto [model, warnings] = obj("v 0 0 0\nv 0 0 1\nv -1 -1 0\nv 1 -1 0\nv 2 -2 1\nf 1 3 2\nf 1 2 4\nf 2 5 4\n");
    REQUIRE(model.triangles.size() == 3);
    const double h = std::sqrt(0.5);
    for (const Corner& corner : model.triangles[0].corners) {
        CHECK(std::abs(corner.normal.x) == Approx(h));
        CHECK(corner.normal.z == Approx(0.0).margin(1e-9));
    }
    CHECK(dot(model.triangles[0].corners[0].normal, model.triangles[1].corners[0].normal) == Approx(0.0).margin(1e-9));
    // A bend of 30 degrees is smoothed.
    const Model smooth = obj("v 0 0 0\nv 0 0 1\nv -1 0 0\nv 0.866 -0.5 0\nf 1 3 2\nf 1 2 4\n").model;
    REQUIRE(smooth.triangles.size() == 2);
    CHECK(dot(smooth.triangles[0].corners[0].normal, smooth.triangles[1].corners[0].normal) == Approx(1.0));
    CHECK(dot(smooth.triangles[0].corners[1].normal, smooth.triangles[1].corners[2].normal) < 0.9);
}

TEST_CASE("obj: normals of length 0 and other than 1") {
    const auto [model, warnings] = obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nvn 0 0 5\nvn 0 3 4\nf 1//1 2//2 3//3\n");
    REQUIRE(model.triangles.size() == 1);
    CHECK(model.triangles[0].corners[0].normal == Vec3{0, 0, 1});  // the face's own
    CHECK(model.triangles[0].corners[1].normal == Vec3{0, 0, 1});
    CHECK(model.triangles[0].corners[2].normal.y == Approx(0.6));
}

namespace {

const std::string square = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";

std::string with_ends(std::string text, const std::string& end) {
    for (std::size_t i = text.find('\n'); i != text.npos; i = text.find('\n', i + end.size())) text.replace(i, 1, end);
    return text;
}

}  // namespace

TEST_CASE("obj: one definition of a line") {
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        INFO(end.size() << ' ' << static_cast<int>(end[0]));
        CHECK(holds(obj_refusal(with_ends(square + "v nan 0 0\nf 1 2 3\n", end)), "test.obj:5: 'nan' is not legal"));
        const auto [model, warnings] =
            obj("\xef\xbb\xbf\xef\xbb\xbf" +
                with_ends("v 5 5 5\n" + square + "# a \\\nf 2 3 4 \\\n 5\ng x\\\nf 2 3 4 # c\n", end));
        CHECK(model.triangles.size() == 3);
        CHECK(warnings.empty());
        for (const Triangle& triangle : model.triangles) {
            for (const Corner& corner : triangle.corners) CHECK(std::abs(corner.position.x) == 1.0);
        }
    }
    CHECK(holds(obj_refusal(std::string("\xff\xfev\0", 4)), "test.obj: this is UTF-16"));
    CHECK(holds(obj_refusal(std::string("\0v", 2)), "byte 0 is 0"));
    CHECK(holds(obj(square + "vx 1\nf 1 2 3\nvy\n").warnings.at(0),
                "2 lines are no OBJ and left out, the first in line 5"));
}

TEST_CASE("obj: corners of faces") {
    for (const std::string face :
         {"1 2 3", "1/ 2/ 3/", "1// 2// 3//", "1/7 2/8 3/9", "-4 -3 -2", "1/-1/ 2 3 # c", "1 2 3#c"}) {
        INFO(face);
        const auto [model, warnings] = obj(square + "f " + face + "\n");
        REQUIRE(model.triangles.size() == 1);
        CHECK(model.triangles[0].corners[2].position == Vec3{1, 1, 0});
        CHECK(warnings.empty());
    }
    for (const std::string corner : {"2.9", "x", "1/2/3/4", "/1", "1 /", "1e0", "nan", "1/x", "1//2.5", "--1"}) {
        INFO(corner);
        CHECK(holds(obj_refusal(square + "f 1 2 3\nf 1 2 " + corner + "\n"), "test.obj:6: '"));
    }
    for (const std::string corner :
         {"5", "4294967299", "4294967297", "99999999999999999999", "0", "-5", "-99999999999999999999"}) {
        INFO(corner);
        CHECK(holds(obj_refusal(square + "f 1 2 3\nf 1 2 " + corner + "\n"),
                    "test.obj:6: a face asks for vertex " + corner + ", there are 4"));
    }
    // A vertex may come after its face, but not for a number that counts back.
    CHECK(obj("f 1 2 3\n" + square).model.triangles.size() == 1);
    CHECK(holds(obj_refusal("f -1 -2 -3\n" + square), "test.obj:1: a face asks for vertex -1, there are 0"));
    CHECK(obj(square + "f 1 2\nf\nf 1 2 3\n").warnings.at(0) == "test.obj: 2 faces without an area are left out");
}

TEST_CASE("obj: normals that are not there are made") {
    for (const std::string face : {"1//1 2//2 3//3", "1//7 2//8 3//9", "1/1/0 2/2/0 3/3/-9"}) {
        const auto [model, warnings] = obj(square + "f " + face + "\n");
        REQUIRE(model.triangles.size() == 1);
        for (const Corner& corner : model.triangles[0].corners) CHECK(corner.normal == Vec3{0, 0, 1});
        CHECK(warnings.size() == 1);
        CHECK(holds(warnings.at(0), "a normal that is not there; it is made from the faces, the first in line 5"));
    }
}

TEST_CASE("obj: numbers are read in double") {
    const Model model =
        obj("v 500000.05 4649776.3 99.8\nv 500000.45 4649776.3 99.8\nv 500000.45 4649776.7 99.8\nf 1 2 3\n").model;
    CHECK(model.triangles.at(0).corners[0].position == Vec3{500000.05, 4649776.3, 99.8});
    CHECK(model.triangles.at(0).corners[0].normal.z == Approx(1.0));
    for (const std::string x : {"+-1", "++1", "--1", "1e", "1.5f", "1,5", "0x1", ".", "-", "1e309", "-nan(ind)"}) {
        CHECK(holds(obj_refusal(square + "v " + x + " 0 0\nf 1 2 3\n"), "test.obj:5: '" + x + "' is not legal"));
    }
}

TEST_CASE("obj: colours of vertices") {
    const auto colour = [](const std::string& rgb) {
        const auto [model, warnings] = obj("v 0 0 0 " + rgb + "\nv 1 0 0 0 0 0\nv 0 1 0\nf 1 2 3\n");
        CHECK(model.triangles.at(0).corners[2].colour == Vec3{1, 1, 1});
        return std::pair(model.triangles.at(0).corners[0].colour, warnings.size());
    };
    CHECK(colour("0.5 0.25 1") == std::pair(Vec3{0.5, 0.25, 1}, std::size_t{0}));
    CHECK(colour("255 51 0") == std::pair(Vec3{1, 0.2, 0}, std::size_t{1}));
    CHECK(colour("65535 51 0") == std::pair(Vec3{1, 0.2, 0}, std::size_t{1}));
    CHECK(colour("1.001 0.5 0") == std::pair(Vec3{1, 0.5, 0}, std::size_t{1}));
    CHECK(colour("-1 0.5 0") == std::pair(Vec3{0, 0.5, 0}, std::size_t{1}));
    CHECK(colour("0.5") == std::pair(Vec3{1, 1, 1}, std::size_t{0}));  // a weight
}

TEST_CASE("obj: material files and names as exporters write them") {
    const Folder folder;
    folder.write("a b.mtl", "newmtl red # the roof\nKd 1 0 0\nnewmtl Material #25\nKd 0 1 0\nnewmtl end\\\nKd 0 0 1\n");
    folder.write("second.MTL", "newmtl red\nKd 0 1 1\nnewmtl grey\nKd 0.5 0.5 0.5\n");
    std::filesystem::create_directory(folder.path() / "sub");
    folder.write("sub/deep.mtl", "newmtl deep\nKd 1 1 0\n");
    struct Case {
        std::string library, material;
        Vec3 colour;
        std::size_t warnings = 0;
    };
    for (const Case& c : {Case{"a b.mtl", "red", {1, 0, 0}},
                          {"a b.mtl # c", "red", {1, 0, 0}},
                          {"\"a b.mtl\"", "red", {1, 0, 0}},
                          {"a b.mtl", "red # c", {1, 0, 0}},
                          {"a b.mtl", "red #c", {1, 0, 0}},
                          {"a b.mtl", "Material #25", {0, 1, 0}},
                          {"a b.mtl", "end\\", {0, 0, 1}},
                          {"a\\ b.mtl", "red", {1, 0, 0}},
                          {".\\a b.mtl", "red", {1, 0, 0}},
                          {"C:\\models\\a b.mtl", "red", {1, 0, 0}},
                          {"/home/nobody/A B.MTL", "red", {1, 0, 0}},
                          {"sub\\deep.mtl", "deep", {1, 1, 0}},
                          {"second.mtl", "red", {0, 1, 1}},
                          {"a b.mtl second.mtl", "grey", {0.5, 0.5, 0.5}},
                          {"a b.mtl second.mtl", "red", {1, 0, 0}},
                          {"none.mtl second.mtl a b.mtl", "red", {0, 1, 1}, 1},
                          {"none.mtl", "red", {0.7, 0.7, 0.7}, 1},
                          {"second.mtl", "blue", {0.7, 0.7, 0.7}, 1}}) {
        for (const bool first : {true, false}) {
            INFO(c.library << ", " << c.material);
            const std::string library = "mtllib " + c.library + "\n";
            const std::string use = square + "usemtl " + c.material + "\n";
            folder.write("a.obj", (first ? library + use : use + library) + "f 1 2 3\n");
            std::vector<std::string> warnings;
            const Model model = read_obj(folder.path() / "a.obj", warnings);
            CHECK(model.materials.at(model.triangles.at(0).material).diffuse == c.colour);
            CHECK(warnings.size() == c.warnings);
            if (c.library.starts_with("none.mtl") && !warnings.empty())
                CHECK(holds(warnings[0], "material file 'none.mtl' is not there"));
            if (c.material == "blue" && !warnings.empty()) CHECK(holds(warnings[0], "material 'blue' is not defined"));
        }
    }
}
