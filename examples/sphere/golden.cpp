#include "golden.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace sphere {
namespace {

using Channels = std::array<std::int64_t, 3>;

/// floor((x + 2^(k-1)) / 2^k)
std::int64_t rnd(std::int64_t x, int k) { return (x + (std::int64_t{1} << (k - 1))) >> k; }

int floor_sqrt(int x) {
    int root = int(std::sqrt(double(x)));
    while (root * root > x) --root;
    while ((root + 1) * (root + 1) <= x) ++root;
    return root;
}

glint_model* open(const char* effect, const char* profile, const char* lobe) {
    glint_model* model = glint_open_effect(effect, profile, lobe);
    if (model == nullptr) throw std::runtime_error(glint_error());
    return model;
}

template <std::size_t Inputs, std::size_t Outputs>
std::array<std::int64_t, Outputs> eval(const glint_model* model, const std::array<std::int64_t, Inputs>& in) {
    std::array<std::int64_t, Outputs> out{};
    std::int32_t clamped = 0;
    if (glint_input_count(model) != Inputs || glint_output_count(model) != Outputs ||
        glint_effect_eval_port(model, in.data(), out.data(), &clamped) != 0) {
        throw std::runtime_error(glint_error());
    }
    return out;
}

/// Three digits in sixteenths, 15 for 1.0 and 8 to 14 for one more than they say.
Channels colour(const std::string& digits) {
    Channels out{};
    for (std::size_t c = 0; c < 3; ++c) {
        const int digit = std::stoi(digits.substr(c, 1), nullptr, 16);
        out[c] = 16 * (digit + digit / 8);
    }
    return out;
}

}  // namespace

Golden::Golden(const std::string& materials, Shading shading, int bits)
    : shading_(shading),
      bits_(bits),
      lambert_(open("lambert", "p8", "decay")),
      blinn_phong_(open("blinn_phong", "p8", "decay")),
      tint_(open("tint", "p8", "decay")),
      pixel_(open("pixel", "p12", "bps")) {
    std::ifstream file(materials);
    std::string line;
    std::size_t count = 0;
    while (std::getline(file, line)) {
        if (line.empty() || line[0] == '/') continue;
        if (count == materials_.size() || line.size() != 15) throw std::runtime_error(materials + ": '" + line + "'");
        materials_[count++] = {std::stoi(line.substr(0, 3), nullptr, 16), colour(line.substr(4, 3)),
                               colour(line.substr(8, 3)), colour(line.substr(12, 3))};
    }
    if (count != materials_.size()) throw std::runtime_error(materials + ": four materials are wanted");
}

Golden::~Golden() {
    for (glint_model* model : {lambert_, blinn_phong_, tint_, pixel_}) glint_close(model);
}

bool Golden::dark(int x, int y, int z) const {
    const int tx = (60 * x + 25 * y) >> 6, ty = 60 * y - 25 * x, tz = (13 * (z >> 4)) >> 6;
    const int c = turn_.x() >> 6, s = turn_.y() >> 6;
    const int u = (tx * c + tz * s) >> 9, w = (tz * c - tx * s) >> 9;
    const int a = u < 0 ? ~u : u, b = w < 0 ? ~w : w;
    const bool sector = ((u < 0) != (w < 0)) != ((a < b) != ((12 * a < 5 * b) != (5 * a < 12 * b)));
    const int height = std::abs(ty);
    const bool band = ((ty < 0) != (height > 10189)) != ((height > 18826) != (height > 24598));
    return sector != band;
}

std::array<int, 3> Golden::lit(int x, int y, int z) const {
    if (shading_ == Shading::full) return lit_full(x, y, z);
    const Material& material = materials_[std::size_t(material_)];
    const std::int64_t w = 5 * ((light_.x() >> 2) * x + (light_.y() >> 2) * y) + 448 * z;
    const std::int64_t nh = rnd(w, 8), nl = rnd(7 * w - 2048 * z, 10);
    const std::int64_t diffuse = eval<1, 1>(lambert_, {nl})[0] + 16;
    const std::int64_t highlight = eval<3, 1>(blinn_phong_, {material.n, nh, nl})[0];
    const Channels& kd = dark(x, y, z) ? material.dark : material.light;
    const Channels& ks = material.highlight;
    const Channels a = eval<7, 3>(tint_, {diffuse, kd[0], kd[1], kd[2], 256, 256, 256});
    const Channels b = eval<7, 3>(tint_, {highlight, ks[0], ks[1], ks[2], 256, 256, 256});
    std::array<int, 3> out{};
    for (std::size_t i = 0; i < 3; ++i) out[i] = 256 * int(std::min<std::int64_t>(255, a[i] + b[i]));
    return out;
}

std::array<int, 3> Golden::lit_full(int x, int y, int z) const {
    const Material& material = materials_[std::size_t(material_)];
    const Channels& kd = dark(x, y, z) ? material.dark : material.light;
    const Channels& ks = material.highlight;
    constexpr std::size_t inputs = 46, colours = 31;  // the ports: docs/effects/pixel.md
    std::array<std::int64_t, inputs> in{};
    const std::int64_t first[] = {
        1 + 2 + 8, 7 * light_.x() >> 2, 7 * light_.y() >> 2, 17408, 0, 0, 32767, 80 * x, 80 * y, z};
    std::copy(std::begin(first), std::end(first), in.begin());
    in[16] = material.n;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::int64_t channel[] = {16 * kd[i], 256, 16 * kd[i], 16 * ks[i], 4096};  // ka, ia, kd, ks, i
        for (std::size_t k = 0; k < 5; ++k) in[colours + 3 * k + i] = channel[k];
    }
    const Channels rgb = eval<inputs, 3>(pixel_, in);
    std::array<int, 3> out{};
    for (std::size_t i = 0; i < 3; ++i) out[i] = 16 * int(std::min<std::int64_t>(4095, rgb[i]));
    return out;
}

Output Golden::at(int h, int v) const {
    Output out;
    out.hsync = h >= 656 && h < 752;
    out.vsync = v >= 490 && v < 492;
    out.visible = h < 640 && v < 480;
    if (!out.visible) return out;
    const int x = 2 * h - 639, y = 479 - 2 * v;
    const int rest = (1 << 22) - 25 * (x * x + y * y);
    const std::array<int, 3> linear = rest < 0 ? std::array{512, 768, 1280} : lit(x, y, floor_sqrt(rest << 8));
    for (std::size_t i = 0; i < 3; ++i) out.colour[i] = floor_sqrt(linear[i]) >> (8 - bits_);
    return out;
}

void Golden::next_picture(const Buttons& buttons) {
    if (buttons.next && !pressed_) material_ = (material_ + 1) % 4;
    pressed_ = buttons.next;
    if (!buttons.hold_turn) turn_.step();
    if (!buttons.hold_light) light_.step();
}

}  // namespace sphere
