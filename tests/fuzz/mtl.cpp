// A text as an MTL file.
#include "check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return glint::fuzz::run([&](std::vector<std::string>& warnings) {
        const std::string text(reinterpret_cast<const char*>(data), size);
        for (const auto& material : glint::render::read_mtl(text, "a.mtl", warnings)) {
            glint::fuzz::check_material(material);
        }
    });
}
