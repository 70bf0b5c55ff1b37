// The dot products that effects take, from vectors of integers: docs/effects/pixel.md, section `Dot products`.
#pragma once

#include <algorithm>
#include <cstdint>

#include "cosine.hpp"
#include "glint/fixed_point.hpp"

namespace glint {

struct Frame {
    int W = 0;  ///< bits of a component; a unit vector has the length 2^(W-1)
    int F = 0;  ///< fraction bits of a dot product, W .. 29

    struct Vector {
        std::int64_t x = 0, y = 0, z = 0;
        friend Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
        friend std::int64_t dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
    };
    struct Dots {
        std::int64_t nl = 0, nv = 0, lv = 0, rv = 0, nh = 0, vh = 0, ht = 0, hb = 0;
    };

    // With |components| <= 2^15 and F <= 29: h.h < 2^34, moved by 2 F + 2 - 2 W bits < 2^62; nl nv <= 2^(2F).
    Dots dots(const Vector& light, const Vector& view, const Vector& normal, const Vector& tangent,
              const Vector& bitangent) const {
        const std::int64_t one = std::int64_t{1} << F;
        const auto cut = [&](std::int64_t x) { return std::clamp(x, -one, one); };
        const auto plain = [&](const Vector& a, const Vector& b) { return cut(rnd(dot(a, b), 2 * W - 2 - F)); };
        const Vector h = light + view;
        const auto cosine = [&](const Vector& a) {
            const std::int64_t x[] = {a.x, a.y, a.z}, y[] = {h.x, h.y, h.z};
            return CosineFormat{W + 1, F}.steps(x, y).c;
        };
        Dots out;
        out.nl = plain(normal, light);
        out.nv = plain(normal, view);
        out.lv = plain(light, view);
        out.rv = cut(rnd(out.nl * out.nv, F - 1) - out.lv);
        out.nh = cosine(normal);
        out.vh = std::min(one, (floor_sqrt(dot(h, h) << (2 * F + 2 - 2 * W)) + 1) >> 1);
        out.ht = cosine(tangent);
        out.hb = cosine(bitangent);
        return out;
    }
};

}  // namespace glint
