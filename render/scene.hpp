// What is rendered: triangles with materials, lights, a camera (docs/rendering.md). Nothing here knows of fixed point.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "vector.hpp"

namespace glint::render {

/// A material after the rules of docs/rendering.md: what is off is empty or black.
struct Material {
    std::string name;
    Vec3 emission;               ///< shown as it is, whatever the light: Kd of `illum 0`
    Vec3 ambient;                ///< Ka, each channel 0 .. 1
    Vec3 diffuse;                ///< Kd
    Vec3 specular;               ///< Ks
    int exponent = 1;            ///< Ns, 1 .. 1023
    double roughness = 0.3;      ///< Pr, 0 .. 1: sigma of oren_nayar, m of cook_torrance, alpha of ward
    double anisotropy = 0;       ///< aniso, 0 .. 0.99: how far the two alphas of ward are apart
    double index = 1.5;          ///< Ni, index of refraction, at least 1
    std::string diffuse_model;   ///< an effect, or empty: no diffuse term
    std::string specular_model;  ///< an effect, or empty: no highlight
    std::string lobe;            ///< of the models made of one; empty: the command line's
};

struct Corner {
    Vec3 position;
    Vec3 normal;           ///< unit length
    Vec3 colour{1, 1, 1};  ///< multiplies Ka and Kd: baked shading, 0 .. 1 a channel
};

struct Triangle {
    std::array<Corner, 3> corners;
    std::uint32_t material = 0;
};

struct Light {
    bool directional = false;
    Vec3 place;   ///< position; of a directional light the unit vector to the light
    Vec3 colour;  ///< times intensity; each channel 0 .. below 16
    /// The colour is divided by attenuation.x + attenuation.y d + attenuation.z d^2, d the distance.
    Vec3 attenuation{1, 0, 0};
};

struct Camera {
    Vec3 eye;
    Vec3 right, up, forward;  ///< orthonormal
    double tangent = 0.0;     ///< of half the vertical field of view
};

struct Scene {
    std::vector<Material> materials;
    std::vector<Triangle> triangles;
    std::vector<Light> lights;
    Vec3 ambient{0.3, 0.3, 0.3};             ///< light that is everywhere, 0 .. below 16
    Vec3 background_top, background_bottom;  ///< linear, 0 .. 1
    Camera camera;
    std::vector<std::string> warnings;         ///< a line each
    std::vector<std::filesystem::path> files;  ///< models and MTL files that were read
};

/// Reads a scene file (.json), or a model (.obj) with defaults for all else. `aspect` is the picture's width over its
/// height: a camera that is not given frames the model in it. Throws Error: a line with the file, what is wrong and
/// what is legal.
Scene load_scene(const std::filesystem::path& path, double aspect);

/// The same for the text of a scene file; `path` names it and is where the files that it names are looked for.
Scene parse_scene(const std::string& text, const std::filesystem::path& path, double aspect);

/// The names that the key `brdf` may have in this build.
std::string known_models();

}  // namespace glint::render
