// What paper 2 claims, held against what is computed: operations, Fig. 1, Fig. 2, likeness of the modified form.

#include "studies/paper2.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "lighting_reference.hpp"

using namespace glint;
using namespace glint::studies;

namespace {

const studies::paper2::Scene scene{{0, 0, 1}, unit_vector(0.5, 0.2), unit_vector(0.4, 3.0), {1, 0, 0}, {0, 1, 0}};
const studies::paper2::Material material;

const studies::paper2::CountedModel& find(const std::vector<studies::paper2::CountedModel>& models,
                                          std::string_view name) {
    const auto found = std::find_if(models.begin(), models.end(), [&](const auto& m) { return m.model == name; });
    REQUIRE(found != models.end());
    return *found;
}

}  // namespace

TEST_CASE("Paper 2: the counted formulas are the models") {
    const LightingReference reference(material);
    const studies::paper2::Scene same_side{
        {0, 0, 1}, unit_vector(0.9, 0.2), unit_vector(0.4, 0.5), {1, 0, 0}, {0, 1, 0}};
    for (const studies::paper2::Scene& s : {scene, same_side}) {
        const auto expected = reference(s);
        const auto models = studies::paper2::counted_models(s, material);
        CHECK(models.size() == expected.size());
        for (const auto& model : models) {
            CAPTURE(model.model);
            CHECK(model.value == Approx(expected.at(std::string(model.name))));
        }
    }
}

TEST_CASE("Paper 2: operations") {
    const auto models = studies::paper2::counted_models(scene, material);
    CHECK(models.size() == 9);
    CHECK(models.front().model == "Lambert");
    CHECK(std::count_if(models.begin(), models.end(),
                        [](const auto& m) { return studies::paper2::printed(m.model); }) == 5);
    const auto of = [&](std::string_view name) { return studies::paper2::total(find(models, name).operations); };
    CHECK(of("Phong") < of("Blinn-Phong"));
    for (const studies::paper2::TableRow& row : studies::paper2::table()) {
        CHECK(of(row.model) > 0);
        if (row.model != "Cook-Torrance") CHECK(of(row.model) < of("Cook-Torrance"));
    }
    CHECK(of("modified Cook-Torrance") < of("Cook-Torrance"));
    CHECK(of("modified Cook-Torrance, N.H") == of("modified Cook-Torrance"));
}

TEST_CASE("Paper 2: figure 1") {
    const auto figure = studies::paper2::figure_1(0.3, 181);
    REQUIRE(figure.x.size() == 181);
    CHECK(figure.x.front() == 0.0);
    CHECK(figure.x.back() == Approx(std::numbers::pi / 2));
    CHECK(figure.distribution.front() == Approx(1.0));
    CHECK(figure.distribution.back() < 1e-12);
    double angle = 0.0, half = 0.0;
    for (std::size_t k = 0; k < figure.x.size(); ++k) {
        angle = std::max(angle, std::abs(figure.angle_cubic[k] - figure.distribution[k]));
        half = std::max(half, std::abs(figure.half_cubic[k] - figure.distribution[k]));
    }
    CHECK(angle == Approx(figure.angle.error().largest).epsilon(0.05));
    CHECK(half == Approx(figure.half.error().largest).epsilon(0.05));
}

TEST_CASE("Paper 2: figure 2") {
    for (const double index : {1.1, 1.5, 2.0, 4.0}) {
        const auto figure = studies::paper2::figure_2(index, 201);
        REQUIRE(figure.x.size() == 201);
        CHECK(figure.reflectance.front() == Approx(1.0));
        CHECK(figure.reflectance.back() == Approx(std::pow((index - 1.0) / (index + 1.0), 2)));
        // "It changes sharply only for V.H from 0 to 0.4."
        CHECK(figure.steep > 0.85);
    }
    // "About its value in [0.4, 1]": a constant is good for large indices and poor for small ones.
    CHECK(studies::paper2::figure_2(4.0, 201).largest < 0.1);
    CHECK(studies::paper2::figure_2(1.5, 201).largest > 1.0);
    const auto nothing = studies::paper2::figure_2(1.0, 11);
    CHECK(nothing.reflectance.front() == 0.0);
    CHECK(nothing.largest == 0.0);
}

TEST_CASE("Paper 2: the modified form looks like Cook-Torrance where the reflectance is a constant") {
    // Normal incidence: the highlight is at V.H = 1, where the reflectance is below its mean.
    const auto dielectric = studies::paper2::likeness(0.3, 1.5, 0.0), bright = studies::paper2::likeness(0.3, 4.0, 0.0);
    CHECK(dielectric.largest == Approx(cook_torrance::mean_fresnel(1.5) / 0.04 - 1.0).epsilon(0.05));
    CHECK(bright.largest < 0.05);
    CHECK(bright.rms < bright.largest);
}

TEST_CASE("Paper 2: Phong and Blinn-Phong at one exponent") {
    for (const double n : {1.0, 10.0, 50.0, 1000.0}) {
        const auto figure = studies::paper2::highlight_figure(n, 1801);
        CAPTURE(n);
        REQUIRE(figure.x.size() == 1801);
        CHECK(figure.phong.front() == 1.0);
        CHECK(figure.blinn_phong.front() == 1.0);
        CHECK(figure.phong.back() < 1e-15);
        CHECK(std::pow(std::cos(figure.phong_width), n) == Approx(0.5));
        CHECK(std::pow(std::cos(0.5 * figure.blinn_phong_width), n) == Approx(0.5));
        CHECK(std::pow(std::cos(0.5 * figure.phong_width), figure.equal_width) == Approx(0.5));
        for (std::size_t k = 1; k < figure.x.size(); ++k) {
            if (figure.blinn_phong[k] <= figure.phong[k]) FAIL("Blinn-Phong is not the wider one at " << figure.x[k]);
        }
        CHECK(figure.largest > 0.0);
        CHECK(figure.largest < 0.6 / n);
    }
    CHECK(studies::paper2::highlight_figure(1000.0, 2).equal_width == Approx(4000.0).epsilon(1e-3));
    CHECK(studies::paper2::highlight_figure(1.0, 2).equal_width > 4.5);
}
