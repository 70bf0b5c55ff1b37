// A block of fragments in double: vectors, light, dot products.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "glint/error.hpp"
#include "scene.hpp"
#include "visibility.hpp"

namespace glint::render {

constexpr std::size_t block_size = 4096;

/// The dot products that effects ask for, by the names of their ports (docs/effects.md).
constexpr std::array<std::string_view, 8> dot_names{"nl", "nv", "nh", "lv", "vh", "ht", "hb", "rv"};
enum Dot : std::size_t { nl, nv, nh, lv, vh, ht, hb, rv };

/// `lane[i]` for the fragments of a block.
using Lane = std::array<double, block_size>;
struct Lanes {
    Lane x, y, z;
    void set(std::size_t i, const Vec3& v) { x[i] = v.x, y[i] = v.y, z[i] = v.z; }
    Vec3 get(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

/// What the light of one kind does to a block, in double.
struct Geometry {
    std::size_t count = 0;
    Lanes position, normal, view, tangent;
    Lanes light;   ///< unit vectors to the light
    Lanes colour;  ///< of the light, attenuated
    std::array<Lane, dot_names.size()> dots;

    void load(const Scene& scene, std::span<const Fragment> fragments, std::span<const std::uint32_t> order,
              bool tangents) {
        count = order.size();
        for (std::size_t i = 0; i < count; ++i) {
            const Fragment& f = fragments[order[i]];
            const Vec3 p{f.position[0], f.position[1], f.position[2]};
            const Vec3 n = direction({f.normal[0], f.normal[1], f.normal[2]});
            position.set(i, p);
            normal.set(i, n);
            view.set(i, direction(scene.camera.eye - p));
            if (tangents) {
                // Around the vertical axis, as on a lathe; where the surface lies flat, along x.
                const Vec3 around = direction(cross({0, 1, 0}, n));
                tangent.set(i, around == Vec3{} ? Vec3{1, 0, 0} : around);
            }
        }
    }

    void illuminate(const Light& source) {
        if (source.directional) {
            for (std::size_t i = 0; i < count; ++i) light.set(i, source.place);
            for (std::size_t i = 0; i < count; ++i) colour.set(i, source.colour);
            return;
        }
        for (std::size_t i = 0; i < count; ++i) {
            const Vec3 to{source.place.x - position.x[i], source.place.y - position.y[i],
                          source.place.z - position.z[i]};
            const double distance = std::sqrt(dot(to, to));
            // A light at the very point of the surface has no direction: N.L is 0.
            const double scale = distance > 0.0 ? 1.0 / distance : 0.0;
            light.set(i, scale * to);
            const Vec3& a = source.attenuation;
            const double falloff = a.x + (a.y + a.z * distance) * distance;
            // Close by, some attenuations are 0: as bright as the port can carry.
            colour.set(i, 1.0 / std::max(falloff, 1e-9) * source.colour);
        }
    }

    /// The dot products that `wanted` names, bit d for dot_names[d].
    void multiply(unsigned wanted) {
        const auto needs = [&](std::initializer_list<Dot> some) {
            return std::any_of(some.begin(), some.end(), [&](Dot d) { return (wanted >> d & 1U) != 0; });
        };
        const auto product = [this](Dot d, const Lanes& a, const Lanes& b) {
            for (std::size_t i = 0; i < count; ++i) dots[d][i] = a.x[i] * b.x[i] + a.y[i] * b.y[i] + a.z[i] * b.z[i];
        };
        if (needs({nl, rv})) product(nl, normal, light);
        if (needs({nv, rv})) product(nv, normal, view);
        if (needs({lv, rv})) product(lv, light, view);
        if (needs({rv})) {
            for (std::size_t i = 0; i < count; ++i) dots[rv][i] = 2.0 * dots[nl][i] * dots[nv][i] - dots[lv][i];
        }
        if (!needs({nh, vh, ht, hb})) return;
        for (std::size_t i = 0; i < count; ++i) {
            const double x = light.x[i] + view.x[i];
            const double y = light.y[i] + view.y[i];
            const double z = light.z[i] + view.z[i];
            const double square = x * x + y * y + z * z;
            // L = -V: there is no half vector, and its dot products are 0.
            const double scale = square > 0.0 ? 1.0 / std::sqrt(square) : 0.0;
            half.x[i] = scale * x;
            half.y[i] = scale * y;
            half.z[i] = scale * z;
        }
        if (needs({nh})) product(nh, normal, half);
        if (needs({vh})) product(vh, view, half);
        if (needs({ht})) product(ht, tangent, half);
        if (needs({hb})) {
            for (std::size_t i = 0; i < count; ++i) {
                dots[hb][i] = dot(cross(normal.get(i), tangent.get(i)), half.get(i));
            }
        }
    }

private:
    Lanes half;
};

inline std::size_t dot_index(std::string_view name) {
    const auto found = std::find(dot_names.begin(), dot_names.end(), name);
    if (found == dot_names.end()) throw Error(fmt::format("dot product '{}' is not known to the renderer", name));
    return static_cast<std::size_t>(found - dot_names.begin());
}

}  // namespace glint::render
