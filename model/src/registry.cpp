// The lists of lobes and of effects. With GLINT_ONLY_LOBE, for a program that tests one lobe: that lobe, and no effect.

#include "glint/effect.hpp"
#include "glint/lobes.hpp"

namespace glint {

// The file of each defines its entry.
#define GLINT_LOBE(name) Lobe name##_lobe();
#define GLINT_EFFECT(name) Effect name##_effect();
#ifdef GLINT_ONLY_LOBE
#define GLINT_ENTRY(name) GLINT_LOBE(name)
GLINT_ENTRY(GLINT_ONLY_LOBE)
#else
#include "glint/effects.def"
#include "glint/lobes.def"
#endif
#undef GLINT_EFFECT
#undef GLINT_LOBE

#define GLINT_LOBE(name) name##_lobe(),
#define GLINT_EFFECT(name) name##_effect(),

std::span<const Lobe> lobes() {
    static const std::vector<Lobe> all{
#ifdef GLINT_ONLY_LOBE
        GLINT_ENTRY(GLINT_ONLY_LOBE)
#else
#include "glint/lobes.def"
#endif
    };
    return all;
}

std::span<const Effect> effects() {
    static const std::vector<Effect> all{
#ifndef GLINT_ONLY_LOBE
#include "glint/effects.def"
#endif
    };
    return all;
}

}  // namespace glint
