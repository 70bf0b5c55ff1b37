// Normals for corners that have none.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "vector.hpp"

namespace glint::render {

/// The mean of the faces around a vertex, weighted by area, that lie within 60 degrees of the corner's own face: a box
/// keeps its edges and a scanned figure looks smooth. Around a vertex with more than 64 faces those of about one
/// direction (8 x 8 on each side of a cube) count as one face, so the work grows with the number of faces alone.
class Smoothing {
public:
    /// `faces` are triangles of vertices, `areas` their normals, each twice as long as the triangle is large.
    Smoothing(std::span<const std::array<std::uint32_t, 3>> faces, std::span<const Vec3> areas, std::size_t vertices);

    /// Of corner 0, 1 or 2 of a face. Unit length.
    Vec3 normal(std::size_t face, std::size_t corner) const { return normals_[3 * face + corner]; }

    /// How often two faces were compared.
    std::uint64_t comparisons() const { return comparisons_; }

private:
    std::vector<Vec3> normals_;
    std::uint64_t comparisons_ = 0;
};

}  // namespace glint::render
