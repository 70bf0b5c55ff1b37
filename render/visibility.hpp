// Which surface each pixel sees: primary rays by Embree.
#pragma once

#include <cstdint>
#include <vector>

#include "glint/parallel.hpp"
#include "scene.hpp"

namespace glint::render {

/// A point of a surface that a ray of the camera meets.
struct Fragment {
    std::uint32_t pixel = 0;  ///< row * width + column
    std::uint32_t material = 0;
    float position[3] = {};
    float normal[3] = {};  ///< unit length, on the side from which it is seen: N.V is above 0
    float colour[3] = {};  ///< of the corners, interpolated
};

/// At most one fragment a pixel, in the order of the pixels, whatever the number of threads (0: one a core).
std::vector<Fragment> cast_rays(const Scene& scene, int width, int height, unsigned threads, const Progress& progress);

/// The version of the ray casting library, for the statistics.
const char* ray_caster();

}  // namespace glint::render
