// A text as an OBJ file, which finds one file of materials.
#include "check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return glint::fuzz::run([&](std::vector<std::string>& warnings) {
        const std::string text(reinterpret_cast<const char*>(data), size);
        const auto find = [](const std::string& name) {
            return name == "a b.mtl" ? std::filesystem::path(GLINT_FUZZ_FOLDER "/a b.mtl") : std::filesystem::path();
        };
        const glint::render::Model model = glint::render::parse_obj(text, "a.obj", find, warnings);
        glint::fuzz::check_triangles(model.triangles, model.materials.size());
        for (const auto& material : model.materials) glint::fuzz::check_material(material);
    });
}
