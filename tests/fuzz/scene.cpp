// A text as a scene file, beside the model a.obj.
#include "scene.hpp"
#include "check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return glint::fuzz::run([&](std::vector<std::string>& warnings) {
        const std::string text(reinterpret_cast<const char*>(data), size);
        const glint::render::Scene scene = glint::render::parse_scene(text, GLINT_FUZZ_FOLDER "/a.json", 1.5);
        warnings = scene.warnings;
        glint::fuzz::check_triangles(scene.triangles, scene.materials.size());
        for (const auto& material : scene.materials) glint::fuzz::check_material(material);
    });
}
