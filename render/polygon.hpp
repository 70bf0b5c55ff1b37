// Polygons as triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "vector.hpp"

namespace glint::render {

struct Triangulation {
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of corners, in the direction of the polygon
    bool simple = true;                                   ///< false: the polygon crosses or covers itself
};

/// Cuts a polygon into triangles that have an area. It may be concave, lie in any plane, run in either direction, have
/// corners on a straight line, repeated corners, and touch itself, as the bridge to a hole does: the areas of the
/// triangles add up to the polygon's. One that is not simple is cut somehow. One without an area gives no triangles.
Triangulation triangulate(std::span<const Vec3> polygon);

}  // namespace glint::render
