// The hard cases of shading, by name, in the engines float and fixed; the engine rtl is held against fixed by
// render_test.py.
#include <array>
#include <cmath>
#include <limits>

#include "catch.hpp"
#include "codes.hpp"
#include "engine.hpp"
#include "glint/effect.hpp"

using namespace glint;
using namespace glint::render;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double ulp = 1.0 / 4096;  // p12

/// One pixel that shows a point at the origin, seen from (0, 0, 2).
struct Point {
    Scene scene;
    Fragment fragment;

    Point() {
        Material material;
        material.ambient = {0.5, 0.5, 0.5};
        material.diffuse = {0.25, 0.5, 1.0};
        material.specular = {1.0, 1.0, 1.0};
        material.exponent = 50;
        material.diffuse_model = "lambert";
        material.specular_model = "blinn_phong";
        scene.materials.push_back(material);
        scene.ambient = {0.25, 0.25, 0.25};
        scene.camera.eye = {0, 0, 2};
        scene.lights.push_back({true, {0, 0, 1}, {1, 1, 1}});
        normal({0, 0, 1});
        fragment.colour[0] = fragment.colour[1] = fragment.colour[2] = 1.0F;
    }

    void normal(const Vec3& n) {
        fragment.normal[0] = static_cast<float>(n.x);
        fragment.normal[1] = static_cast<float>(n.y);
        fragment.normal[2] = static_cast<float>(n.z);
    }

    Shading shade(bool exact, bool all_effects = false) const {
        const std::vector<Fragment> fragments{fragment};
        const Plan plan = make_plan(scene, fragments, "bps", all_effects);
        return render::shade(scene, plan, fragments, 1, 1, parse_profile("p12"), exact ? golden_unit : MakeUnit{}, 1,
                             {});
    }

    /// The colour by the golden models, when it is finite, not negative and near that of the real functions.
    Vec3 colour() const {
        const Vec3 exact = shade(true).samples.pixels[0];
        const Vec3 real = shade(false).samples.pixels[0];
        for (const auto& [e, r] : {std::array{exact.x, real.x}, {exact.y, real.y}, {exact.z, real.z}}) {
            CHECK(std::isfinite(e));
            CHECK(std::isfinite(r));
            CHECK(e >= 0.0);
            CHECK(r >= 0.0);
            CHECK(std::abs(e - r) < 4 * ulp);
        }
        return exact;
    }
};

constexpr Vec3 ambient_alone{0.125, 0.125, 0.125};

}  // namespace

TEST_CASE("shading: light, viewer and normal in one line") {
    const Vec3 colour = Point().colour();
    // ambient + Kd + Ks f_bps(1); f_bps(1) is 0.992737.
    CHECK(std::abs(colour.x - (0.125 + 0.25 + 0.992737)) <= 2 * ulp);
    CHECK(std::abs(colour.z - (0.125 + 1.0 + 0.992737)) <= 2 * ulp);
}

TEST_CASE("shading: L = -V, no half vector") {
    Point point;
    point.scene.lights[0].place = {0, 0, -1};
    CHECK(point.colour() == ambient_alone);  // the light is behind the surface
    point.normal({0, 0, -1});                // and with a normal that looks away from the viewer, in front of it
    const Vec3 colour = point.colour();
    CHECK(std::abs(colour.x - (0.125 + 0.25 + 0.002737)) <= 2 * ulp);  // f_bps(0): N.H counts as 0
}

TEST_CASE("shading: light behind the surface") {
    Point point;
    for (const Vec3& place : {Vec3{0, 0, -1}, Vec3{0.6, 0, -0.8}, Vec3{1, 0, -1e-3}}) {
        point.scene.lights[0].place = direction(place);
        CHECK(point.colour() == ambient_alone);
    }
}

TEST_CASE("shading: grazing light, N.L of 0 and of 1 ulp") {
    Point point;
    point.scene.lights[0].place = {1, 0, 0};
    CHECK(point.colour() == ambient_alone);
    // N.L is one code above 0: no diffuse light yet, the whole lobe at N.H = cos 45 degrees.
    const double one_code = std::ldexp(1.0, -18);
    point.scene.lights[0].place = {std::sqrt(1.0 - one_code * one_code), 0, one_code};
    const Vec3 above = point.shade(true).samples.pixels[0];
    const auto lobe = find_effect("blinn_phong").golden(parse_profile("p12"), "bps");
    const std::int64_t in[] = {50, std::llround(std::ldexp(std::sqrt(0.5), 18)), 1};
    const auto y = static_cast<double>(lobe->eval_port(in).values[0]);
    CHECK(above.x == 0.125 + y * ulp);
    point.scene.lights[0].place.z = -one_code;
    CHECK(point.colour() == ambient_alone);
}

TEST_CASE("shading: normals of length 0 and other than 1") {
    Point point;
    const Vec3 unit = point.colour();
    for (const double length : {1e-3, 0.5, 3.0, 1e6}) {
        point.normal({0, 0, length});
        CHECK(point.colour() == unit);
    }
    for (const Vec3& none : {Vec3{0, 0, 0}, Vec3{not_a_number, 0, 1}, Vec3{infinite, 0, 0}}) {
        point.normal(none);
        CHECK(point.colour() == ambient_alone);
    }
}

TEST_CASE("shading: dot products above 1") {
    Point point;
    const Vec3 unit = point.colour();
    point.scene.lights[0].place = {0, 0, 1.0 + 1e-5};  // N.L is 3 codes above 1, N.H rounds to 1
    const Shading shading = point.shade(true);
    CHECK(shading.corrected == 2);  // of lambert and of blinn_phong
    CHECK(point.colour() == unit);
    point.scene.lights[0].place = {0, 0, 1.0 + 1e-15};
    CHECK(point.shade(true).corrected == 0);
    CHECK(point.colour() == unit);
}

TEST_CASE("shading: a light at the very point, and a surface at the eye") {
    Point point;
    point.scene.lights[0] = {false, {0, 0, 0}, {1, 1, 1}, {0, 0, 1}};
    CHECK(point.colour() == ambient_alone);
    point.scene.lights[0].place = {0, 0, 1e-9};  // attenuation 0: as bright as the port can carry, and finite
    CHECK(point.shade(true).samples.pixels[0].z > 15.0);
    CHECK(point.shade(false).samples.pixels[0].z > 15.0);
    point.scene.lights[0] = {true, {0, 0, 1}, {1, 1, 1}};
    point.scene.camera.eye = {0, 0, 0};
    point.colour();
}

TEST_CASE("shading: no light") {
    Point point;
    point.scene.lights.clear();
    const Plan plan = make_plan(point.scene, {point.fragment}, "bps", false);
    REQUIRE(plan.units.size() == 1);
    CHECK(plan.units[0].effect == "ambient");
    CHECK(point.colour() == ambient_alone);
    point.scene.ambient = {};
    CHECK(make_plan(point.scene, {point.fragment}, "bps", false).units.empty());
    CHECK(point.colour() == Vec3{});
}

TEST_CASE("shading: a position that is no number") {
    Point point;
    point.scene.lights[0] = {false, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}};
    point.fragment.position[1] = std::numeric_limits<float>::quiet_NaN();
    CHECK(point.shade(true).samples.pixels[0] == ambient_alone);
    const Vec3 real = point.shade(false).samples.pixels[0];
    CHECK((std::isfinite(real.x) && std::isfinite(real.y) && std::isfinite(real.z)));
}

TEST_CASE("shading: nothing to shade shows the background") {
    Scene scene;
    scene.background_top = {0.5, 0, 0};
    scene.background_bottom = {0, 0.5, 0};
    const Plan plan = make_plan(scene, {}, "bps", true);
    CHECK(plan.units.empty());
    const Shading shading = shade(scene, plan, {}, 2, 2, parse_profile("p12"), golden_unit, 0, {});
    CHECK(shading.samples.pixels[0].x == Approx(0.375));
    CHECK(shading.samples.pixels[3].y == Approx(0.375));
}

TEST_CASE("plan: what a material calls for, and no more") {
    Point point;
    Material matte = point.scene.materials[0];
    matte.specular = {};
    matte.specular_model = "";
    matte.ambient = {};
    Material phong = point.scene.materials[0];
    phong.specular_model = "phong";
    phong.lobe = "cayley";
    Material unseen = point.scene.materials[0];
    unseen.lobe = "schlick";
    point.scene.materials = {matte, phong, unseen};
    point.scene.lights.push_back(point.scene.lights[0]);
    Fragment other = point.fragment;
    other.material = 1;
    other.pixel = 1;
    const std::vector<Fragment> fragments{point.fragment, other};
    const Plan plan = make_plan(point.scene, fragments, "bps", false);
    REQUIRE(plan.materials.size() == 2);
    CHECK(plan.materials[0].terms.size() == 1);
    CHECK(plan.materials[1].terms.size() == 2);
    REQUIRE(plan.units.size() == 4);
    const auto evaluations = [&](const Plan& of, const std::string& effect, const std::string& lobe) {
        std::uint64_t out = 0;
        for (const UnitPlan& unit : of.units) out += unit.effect == effect && unit.lobe == lobe ? unit.evaluations : 0;
        return out;
    };
    CHECK(evaluations(plan, "lambert", "") == 4);
    CHECK(evaluations(plan, "phong", "cayley") == 2);
    CHECK(evaluations(plan, "ambient", "") == 1);
    CHECK(evaluations(plan, "tint", "") == 6);
    CHECK(std::find(plan.not_needed.begin(), plan.not_needed.end(), "blinn_phong") != plan.not_needed.end());

    // Only the units of the plan are brought up, each once a thread, and the counts come true.
    std::vector<std::string> made;
    const auto make = [&](const EffectModel& model, const std::string& lobe) {
        made.push_back(std::string(model.effect()) + lobe);
        return golden_unit(model, lobe);
    };
    const Profile profile = parse_profile("p12");
    const Shading few = shade(point.scene, plan, fragments, 2, 1, profile, make, 1, {});
    CHECK(made == std::vector<std::string>{"lambert", "tint", "ambient", "phongcayley"});
    // Every unit on every fragment: more work, the same picture.
    const Plan all = make_plan(point.scene, fragments, "bps", true);
    CHECK(all.units.size() > plan.units.size());
    CHECK(all.not_needed.empty());
    CHECK(evaluations(all, "lambert", "") == 4);
    CHECK(evaluations(all, "ambient", "") == 2);
    CHECK(shade(point.scene, all, fragments, 2, 1, profile, golden_unit, 1, {}).samples.pixels == few.samples.pixels);
}

TEST_CASE("shading: the result does not depend on the number of threads") {
    Point point;
    point.scene.lights.push_back({false, {1, 2, 3}, {0.5, 0.6, 0.7}, {1, 0.1, 0.2}});
    std::vector<Fragment> fragments;
    for (std::uint32_t i = 0; i < 20000; ++i) {
        Fragment f = point.fragment;
        f.pixel = i;
        f.normal[0] = std::sin(static_cast<float>(i));
        f.position[1] = static_cast<float>(i % 100) * 0.01F;
        fragments.push_back(f);
    }
    const Plan plan = make_plan(point.scene, fragments, "cayley", false);
    for (const MakeUnit& make : {MakeUnit{}, MakeUnit{golden_unit}}) {
        const auto run = [&](unsigned threads) {
            return shade(point.scene, plan, fragments, 200, 100, parse_profile("p12"), make, threads, {})
                .samples.pixels;
        };
        CHECK(run(1) == run(3));
    }
}

TEST_CASE("shading: columns of codes are EffectPort::code") {
    for (const char* effect : {"blinn_phong", "tint"}) {
        const auto model = find_effect(effect).golden(parse_profile("p16"), "bps");
        for (const EffectPort& port : model->inputs()) {
            std::vector<double> x{0.0, -0.0, not_a_number, infinite, -infinite, 1e300, -1e300, 1.0, -1.0, 5e-324};
            for (std::int64_t k = -3; k < 40; ++k) {
                for (const double part : {0.0, 0.25, 0.5, 0.75}) {
                    const double exact = std::ldexp(static_cast<double>(k * k * k) + part, -port.fraction_bits);
                    x.insert(x.end(), {exact, -exact, std::nextafter(exact, 1e9), std::nextafter(exact, -1e9)});
                }
            }
            std::vector<std::int32_t> out(x.size());
            codes(port, x, out.data());
            for (std::size_t i = 0; i < x.size(); ++i) CHECK(out[i] == port.code(x[i]));
        }
    }
}
