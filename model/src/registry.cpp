// The lists of lobes and of effects, GLINT_ALL_LOBES and GLINT_ALL_EFFECTS, are those of registry.cmake; a program that
// tests one lobe has that lobe, and no effect.

#include "glint/effect.hpp"
#include "glint/lobes.hpp"

namespace glint {

// The file of each defines its entry.
#define GLINT_LOBE(name) Lobe name##_lobe();
#define GLINT_EFFECT(name) Effect name##_effect();
GLINT_ALL_LOBES GLINT_ALL_EFFECTS;
#undef GLINT_EFFECT
#undef GLINT_LOBE

#define GLINT_LOBE(name) name##_lobe(),
#define GLINT_EFFECT(name) name##_effect(),

std::span<const Lobe> lobes() {
    static const std::vector<Lobe> all{GLINT_ALL_LOBES};
    return all;
}

std::span<const Effect> effects() {
    static const std::vector<Effect> all{GLINT_ALL_EFFECTS};
    return all;
}

}  // namespace glint
