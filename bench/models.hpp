// The lighting models of paper 2 in double and float as they are timed: the formulas of studies/lighting.hpp, each as
// a loop over independent pixels and as a chain of evaluations of which each waits for the one before.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "studies/lighting.hpp"

namespace glint::bench {

/// Random pixels where there is a highlight to see: the half vector 1 to `widest` degrees from the normal, the light 1
/// to 48 from the half vector, to any side, and the surface in any direction. Legal: 1 < widest <= 40, so that N.L and
/// N.V are above 0.
std::vector<studies::paper2::Scene> highlight_scenes(std::size_t count, double widest);

/// Pixels in a number type, of one material.
template <class T>
struct ModelInputs {
    std::vector<lighting::Pixel<T>> pixels;
    lighting::Uniforms<T> uniforms;

    /// Throws Error unless the material is legal for Cook-Torrance.
    ModelInputs(const std::vector<studies::paper2::Scene>& scenes, const studies::paper2::Material& material)
        : pixels(scenes.begin(), scenes.end()), uniforms(material) {}
};

template <class T>
struct ModelFunction {
    std::string_view name;     ///< as studies::paper2::CountedModel has it
    std::string_view formula;  ///< as evaluated
    /// All pixels, each by itself.
    void (*each)(const ModelInputs<T>&, T* y);
    /// The last result of y = f(pixel) with zero y added to the x of the pixel's light: with zero = 0, which the
    /// compiler does not know, each result is that of the pixel alone but waits for the one before.
    T (*chain)(const ModelInputs<T>&, T zero);
};

/// Every model, one evaluation at a time; T is double or float.
template <class T>
std::vector<ModelFunction<T>> model_functions();

/// The chain around no model: what a chain costs beyond its model.
template <class T>
ModelFunction<T> model_dependency();

}  // namespace glint::bench
