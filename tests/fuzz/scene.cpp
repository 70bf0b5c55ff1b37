// A text as a scene file, beside the model a.obj.
#include "scene.hpp"
#include "render_checks.hpp"
#include "targets.hpp"

namespace glint::fuzz {

static const Registration scene("scene", [](const std::string& text) {
    read([&](std::vector<std::string>& warnings) {
        const render::Scene scene = render::parse_scene(text, GLINT_FUZZ_FOLDER "/a.json", 1.5);
        warnings = scene.warnings;
        check_triangles(scene.triangles, scene.materials.size());
        for (const auto& material : scene.materials) check_material(material);
    });
});

}  // namespace glint::fuzz
