// One evaluation at a time: compiled without vectorization (CMakeLists.txt).

#include "models.hpp"

namespace glint::bench {
namespace {

// Flattened: a call of a model, and the pixel through memory, would be no part of its formula.

template <class Model, class T>
[[gnu::flatten]] void each(const ModelInputs<T>& in, T* __restrict y) {
    const lighting::Uniforms<T> uniforms = in.uniforms;
    const lighting::Pixel<T>* pixels = in.pixels.data();
    const std::size_t count = in.pixels.size();
    for (std::size_t i = 0; i < count; ++i) y[i] = Model{}(pixels[i], uniforms);
}

template <class Model, class T>
[[gnu::flatten]] T chain(const ModelInputs<T>& in, T zero) {
    const lighting::Uniforms<T> uniforms = in.uniforms;
    const lighting::Pixel<T>* pixels = in.pixels.data();
    const std::size_t count = in.pixels.size();
    T y{0};
    for (std::size_t i = 0; i < count; ++i) {
        lighting::Pixel<T> pixel = pixels[i];
        pixel.L.x += zero * y;
        y = Model{}(pixel, uniforms);
    }
    return y;
}

struct Dependency {
    static constexpr std::string_view name = "dependency", text = "L.x + zero y";
    template <class T>
    T operator()(const lighting::Pixel<T>& pixel, const lighting::Uniforms<T>&) const {
        return pixel.L.x;
    }
};

template <class Model, class T>
ModelFunction<T> function() {
    return {Model::name, Model::text, each<Model, T>, chain<Model, T>};
}

}  // namespace

template <class T>
std::vector<ModelFunction<T>> model_functions() {
    return std::apply([](auto... model) { return std::vector<ModelFunction<T>>{function<decltype(model), T>()...}; },
                      lighting::All{});
}

template <class T>
ModelFunction<T> model_dependency() {
    return function<Dependency, T>();
}

template std::vector<ModelFunction<double>> model_functions();
template std::vector<ModelFunction<float>> model_functions();
template ModelFunction<double> model_dependency();
template ModelFunction<float> model_dependency();

}  // namespace glint::bench
