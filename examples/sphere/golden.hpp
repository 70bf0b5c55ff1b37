// The sphere, number by number, with the golden models of Glint for what Glint's units compute
// (examples/sphere/README.md).
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "glint.h"

namespace sphere {

/// A colour as the screen gets it.
using Colour = std::array<int, 3>;

/// What the ports show in one clock, the marks active high.
struct Output {
    bool hsync = false, vsync = false, visible = false;
    Colour colour{};  ///< 0 where it is not visible
    friend bool operator==(const Output&, const Output&) = default;
};

/// Buttons during a picture.
struct Buttons {
    bool next = false, hold_turn = false, hold_light = false;
};

/// A point on a circle, code / 2^15, and its next step: sphere_turn.
class Turn {
public:
    Turn(int shift, int x0, int y0) : shift_(shift), x_(x0 * 256), y_(y0 * 256 - (x0 * 256 >> (shift + 1))) {}
    int x() const { return x_ >> 8; }
    int y() const { return (y_ + next()) >> 9; }
    void step() {
        y_ = next();
        x_ -= y_ >> shift_;
    }

private:
    int next() const { return y_ + (x_ >> shift_); }
    int shift_, x_, y_;
};

/// Which sphere_pixel: glint_effect_pixel at p12, or lambert, blinn_phong and tint at p8.
enum class Shading { full, small };

class Golden {
public:
    /// `materials` is the file materials.hex, `bits` those of a colour. Throws std::runtime_error.
    Golden(const std::string& materials, Shading shading, int bits);
    ~Golden();
    Golden(const Golden&) = delete;
    Golden& operator=(const Golden&) = delete;

    /// What goes out in clock `h` (0 .. 799) of line `v` (0 .. 524).
    Output at(int h, int v) const;
    /// Between two pictures.
    void next_picture(const Buttons& buttons);

private:
    struct Material {
        int n = 1;
        std::array<std::int64_t, 3> light{}, dark{}, highlight{};  ///< red, green, blue; code / 2^8
    };
    bool dark(int x, int y, int z) const;
    /// Red, green, blue of a point of the sphere, linear, code / 2^16.
    std::array<int, 3> lit(int x, int y, int z) const;
    std::array<int, 3> lit_full(int x, int y, int z) const;

    std::array<Material, 4> materials_{};
    Shading shading_;
    int bits_;
    glint_model *lambert_, *blinn_phong_, *tint_, *pixel_;
    Turn turn_{6, 32600, 0}, light_{7, -9973, 12337};
    int material_ = 0;
    bool pressed_ = false;
};

}  // namespace sphere
