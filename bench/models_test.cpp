#include "models.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "catch.hpp"
#include "lighting_reference.hpp"

using namespace glint;
using namespace glint::bench;

namespace {

const studies::paper2::Material material;

template <class T>
std::vector<T> values(const ModelFunction<T>& function, const ModelInputs<T>& in) {
    std::vector<T> y(in.pixels.size(), T{-1});
    function.each(in, y.data());
    return y;
}

/// Within so many units in the last place of the number type, relative to the value.
template <class T>
void check_values(double units) {
    const auto scenes = highlight_scenes(1000, 39.0);
    const ModelInputs<T> in(scenes, material);
    const LightingReference reference(material);
    const auto functions = model_functions<T>();
    REQUIRE(functions.size() == studies::paper2::counted_models(scenes.front(), material).size());
    for (const ModelFunction<T>& function : functions) {
        const std::vector<T> y = values(function, in);
        REQUIRE(y.size() == 1000);
        for (std::size_t i = 0; i < y.size(); ++i) {
            const double exact = reference(scenes[i]).at(std::string(function.name));
            const double tolerance = units * std::numeric_limits<T>::epsilon() * exact;
            if (!(exact > 0.0 && std::abs(y[i] - exact) <= tolerance))
                FAIL(function.name << " at pixel " << i << ": " << y[i] << " is not " << exact << " within "
                                   << tolerance);
        }
    }
}

template <class T>
void check_chains() {
    const auto scenes = highlight_scenes(200, 25.0);
    const ModelInputs<T> in(scenes, material);
    for (const ModelFunction<T>& function : model_functions<T>()) {
        INFO(function.name);
        const std::vector<T> y = values(function, in);
        CHECK(function.chain(in, T{0}) == y.back());
        // The result before reaches the next pixel: the first has none before it.
        const ModelInputs<T> two({scenes[198], scenes[199]}, material), one({scenes[199]}, material);
        const T zero = T{1} / 1024;
        CHECK(one.pixels.front().L.x == in.pixels.back().L.x);
        CHECK(function.chain(one, zero) == y.back());
        CHECK(function.chain(two, zero) != y.back());
    }
    CHECK(model_dependency<T>().chain(in, T{0}) == in.pixels.back().L.x);
    CHECK(model_dependency<T>().chain(in, T{1} / 1024) != in.pixels.back().L.x);
}

}  // namespace

TEST_CASE("bench: the timed lighting models have the values of the effects' references") {
    check_values<double>(1000);
    check_values<float>(1000);
}

TEST_CASE("bench: the timed lighting models are those that are counted") {
    const auto scenes = highlight_scenes(20, 39.0);
    const ModelInputs<double> in(scenes, material);
    const auto functions = model_functions<double>();
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const auto counted = studies::paper2::counted_models(scenes[i], material);
        REQUIRE(counted.size() == functions.size());
        for (std::size_t k = 0; k < counted.size(); ++k) {
            INFO(functions[k].name);
            CHECK(functions[k].name == counted[k].name);
            CHECK(values(functions[k], in)[i] == Approx(counted[k].value).epsilon(1e-14));
        }
    }
}

TEST_CASE("bench: pixels have a highlight to see, and both sides of every branch") {
    const auto scenes = highlight_scenes(2048, 39.0);
    const ModelInputs<double> in(scenes, material);
    std::size_t half_cut = 0, angle_cut = 0, shadowed = 0, opposite = 0;
    for (const auto& p : in.pixels) {
        for (const auto& v : {p.N, p.L, p.V, p.T, p.B}) CHECK(std::abs(dot(v, v) - 1.0) < 1e-14);
        for (const double right : {dot(p.N, p.T), dot(p.N, p.B), dot(p.T, p.B)}) CHECK(std::abs(right) < 1e-14);
        const lighting::Cosines<double> c(p);
        CHECK(c.nl > 0.03);
        CHECK(c.nv > 0.03);
        CHECK(c.nh >= std::cos(39.0 * std::numbers::pi / 180.0) - 1e-14);
        half_cut += 1.0 - c.nh >= in.uniforms.half.end ? 1 : 0;
        angle_cut += std::acos(c.nh) >= in.uniforms.angle.end ? 1 : 0;
        shadowed += 2.0 * c.nh * std::min(c.nl, c.nv) < c.vh ? 1 : 0;
        opposite += dot(p.L, p.V) < c.nl * c.nv ? 1 : 0;
    }
    for (const std::size_t some : {half_cut, angle_cut, shadowed, opposite}) {
        CHECK(some > 20);
        CHECK(some < 2028);
    }
    for (const auto& p : ModelInputs<double>(highlight_scenes(2048, 25.0), material).pixels) {
        const double nh = lighting::Cosines<double>(p).nh;
        CHECK(std::acos(nh) < in.uniforms.angle.end);
        CHECK(1.0 - nh < in.uniforms.half.end);
    }
}

TEST_CASE("bench: in a chain of a lighting model every result reaches the next pixel") {
    check_chains<double>();
    check_chains<float>();
}
