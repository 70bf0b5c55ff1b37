// Wavefront OBJ and MTL files. What of them is read, and how, is in docs/rendering.md.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "scene.hpp"

namespace glint::render {

struct Model {
    std::vector<Material> materials;           ///< the last one is for faces without a material
    std::vector<Triangle> triangles;           ///< materials are indices into `materials`; normals have unit length
    std::vector<std::filesystem::path> files;  ///< that were read
};

/// Reads a model and the MTL files that it names. A line per warning is added to `warnings`. Throws Error when a file
/// cannot be read or is no text, holds what is no finite number, refers to vertices that are not there, or has no faces
/// with an area.
Model read_obj(const std::filesystem::path& path, std::vector<std::string>& warnings);

/// A file that a model names, or an empty path where there is none of that name.
using FindFile = std::function<std::filesystem::path(const std::string& name)>;

/// The same for a text in memory; `file` names it in messages, `find` finds its MTL files.
Model parse_obj(std::string_view text, const std::string& file, const FindFile& find,
                std::vector<std::string>& warnings);

/// The materials of an MTL text; `file` names it in messages. Throws Error.
std::vector<Material> read_mtl(std::string_view text, const std::string& file, std::vector<std::string>& warnings);

/// `Ns` as an exponent: fractions rounded half away from zero, 0 counts as 1, above 1023 as 1023; the last two warn.
int exponent(double ns, const std::string& material, std::vector<std::string>& warnings);

/// Sets the models that `brdf` names: at most one diffuse and one specular, separated by spaces. Throws Error with the
/// list of the known ones.
void set_models(Material& material, const std::string& names, const std::string& where);

}  // namespace glint::render
