// A text as an MTL file.
#include "render_checks.hpp"
#include "targets.hpp"

namespace glint::fuzz {

static const Registration mtl("mtl", [](const std::string& text) {
    read([&](std::vector<std::string>& warnings) {
        for (const auto& material : render::read_mtl(text, "a.mtl", warnings)) check_material(material);
    });
});

}  // namespace glint::fuzz
