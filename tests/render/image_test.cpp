#include "image.hpp"

#include <cmath>
#include <limits>

#include "catch.hpp"

using namespace glint::render;

namespace {

Picture flat(int width, int height, double level) {
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    return {width, height, std::vector<Vec3>(count, {level, level, level})};
}

/// The linear value that is shown as this code.
double linear(int code) {
    const double x = code / 255.0;
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

}  // namespace

TEST_CASE("image: sRGB") {
    CHECK(srgb(0.0) == 0);
    CHECK(srgb(1.0) == 255);
    CHECK(srgb(-1.0) == 0);
    CHECK(srgb(7.0) == 255);
    CHECK(srgb(0.5) == 188);
    CHECK(srgb(0.0031308) == 10);
    for (int code = 0; code < 256; ++code) CHECK(srgb(linear(code)) == code);
}

TEST_CASE("image: samples are cut before they are averaged") {
    Picture samples = flat(4, 2, 0.25);
    samples.pixels[0] = {9.0, -3.0, 0.5};
    const Picture out = finish(samples, 2);
    REQUIRE(out.pixels.size() == 2);
    CHECK(out.pixels[0].x == Approx((1.0 + 3 * 0.25) / 4));
    CHECK(out.pixels[0].y == Approx(3 * 0.25 / 4));
    CHECK(out.pixels[0].z == Approx((0.5 + 3 * 0.25) / 4));
    CHECK(out.pixels[1].x == Approx(0.25));
}

TEST_CASE("image: equal pictures") {
    const Picture a = flat(20, 15, 0.3);
    const Distance distance = compare(a, a);
    CHECK(distance.largest == 0);
    CHECK(distance.unequal == 0);
    CHECK(std::isinf(distance.psnr));
    CHECK(distance.ssim == Approx(1.0));
}

TEST_CASE("image: PSNR and SSIM of flat pictures are their formulas") {
    for (const int width : {40, 7}) {  // the second is one window
        const Distance distance = compare(flat(width, 30, linear(110)), flat(width, 30, linear(100)));
        CHECK(distance.largest == 10);
        CHECK(distance.unequal == static_cast<std::uint64_t>(30 * width));
        CHECK(distance.psnr == Approx(20.0 * std::log10(255.0 / 10.0)));
        const double c1 = 2.55 * 2.55;
        CHECK(distance.ssim == Approx((2.0 * 110 * 100 + c1) / (110.0 * 110 + 100.0 * 100 + c1)));
    }
}

TEST_CASE("image: structure that is turned around has a negative SSIM") {
    Picture a = flat(32, 32, 0.0);
    Picture b = a;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double x = linear((i + i / 32) % 2 == 0 ? 90 : 160);
        const double y = linear((i + i / 32) % 2 == 0 ? 160 : 90);
        a.pixels[i] = {x, x, x};
        b.pixels[i] = {y, y, y};
    }
    CHECK(compare(a, b).ssim < -0.9);
    CHECK(compare(a, a).ssim == Approx(1.0));
}

TEST_CASE("image: the difference and its bar") {
    const Picture a = flat(480, 10, 0.5);
    Picture b = a;
    b.pixels[7].y = 0.25;
    const Picture out = difference(a, b, 0.25, "quarters");
    REQUIRE(out.width == 480);
    REQUIRE(out.height == 34);
    CHECK(out.pixels[7] == Vec3{1, 1, 1});
    CHECK(out.pixels[8] == Vec3{0, 0, 0});
    double brightest = 0.0;
    for (std::size_t i = 480 * 10; i < out.pixels.size(); ++i) brightest = std::max(brightest, out.pixels[i].z);
    CHECK(brightest > 0.9);  // the bar's right end
}

TEST_CASE("image: PNG") { CHECK(png(flat(3, 2, 0.5)).substr(0, 8) == "\x89PNG\r\n\x1a\n"); }
