// A text as an OBJ file, which finds one file of materials.
#include "render_checks.hpp"
#include "targets.hpp"

namespace glint::fuzz {

static const Registration obj("obj", [](const std::string& text) {
    read([&](std::vector<std::string>& warnings) {
        const auto find = [](const std::string& name) {
            return name == "a b.mtl" ? std::filesystem::path(GLINT_FUZZ_FOLDER "/a b.mtl") : std::filesystem::path();
        };
        const render::Model model = render::parse_obj(text, "a.obj", find, warnings);
        check_triangles(model.triangles, model.materials.size());
        for (const auto& material : model.materials) check_material(material);
    });
});

}  // namespace glint::fuzz
