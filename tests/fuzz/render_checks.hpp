// What the renderer can take.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "check.hpp"
#include "wavefront.hpp"

namespace glint::fuzz {

inline void check_material(const render::Material& m) {
    for (const render::Vec3& k : {m.emission, m.ambient, m.diffuse, m.specular}) {
        for (const double x : {k.x, k.y, k.z}) require(x >= 0.0 && x <= 1.0, "colours are 0 .. 1");
    }
    require(m.exponent >= 1 && m.exponent <= 1023, "Ns");
    require(m.roughness >= 0.0 && m.roughness <= 1.0, "Pr");
    require(m.anisotropy >= 0.0 && m.anisotropy <= 0.99, "aniso");
    require(m.index >= 1.0 && m.index <= 10.0, "Ni");
}

inline void check_triangles(const std::vector<render::Triangle>& triangles, std::size_t materials) {
    require(!triangles.empty(), "there are triangles");
    for (const render::Triangle& triangle : triangles) {
        require(triangle.material < materials, "the material is there");
        for (const render::Corner& corner : triangle.corners) {
            require(std::isfinite(render::length(corner.position)), "positions are finite");
            const double length = render::length(corner.normal);
            require(length == 0.0 || std::abs(length - 1.0) < 1e-6, "normals have length 1");
            for (const double x : {corner.colour.x, corner.colour.y, corner.colour.z}) {
                require(x >= 0.0 && x <= 1.0, "colours of vertices are 0 .. 1");
            }
        }
    }
}

/// Runs a reader; an Error is one line, and so is each warning: both are printed as they are.
void read(auto reader) {
    std::vector<std::string> warnings;
    try {
        reader(warnings);
    } catch (const Error& error) {
        check_line(error.what());
    }
    for (const std::string& warning : warnings) check_line(warning);
}

}  // namespace glint::fuzz
