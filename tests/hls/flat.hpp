// Included after a top function's source (a forced include): its C twin `<top>_flat(in, out)` with every port an
// int32_t, inputs and then outputs in the order of the arguments; of a lobe one output, the result word. So whatever
// types the kernel is compiled with, and by whatever compiler, the tests call it in one way.
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

#ifndef GLINT_FLAT_HPP
#define GLINT_FLAT_HPP
namespace glint_flat {

constexpr std::size_t sum() { return 0; }
template <class... Rest>
constexpr std::size_t sum(bool first, Rest... rest) {
    return (first ? 1 : 0) + sum(rest...);
}

template <class T>
T* pin(T& value, std::true_type) {
    return &value;
}
template <class T>
T pin(T& value, std::false_type) {
    return value;
}

template <class... Arguments>
struct Top {
    static constexpr std::size_t inputs = sum(!std::is_pointer<Arguments>::value...);
    using Values = std::tuple<std::remove_pointer_t<Arguments>...>;

    template <std::size_t... I, std::size_t... O>
    static void call(void (*top)(Arguments...), const std::int32_t* in, std::int32_t* out, std::index_sequence<I...>,
                     std::index_sequence<O...>) {
        Values values{static_cast<std::tuple_element_t<I, Values>>(I < inputs ? in[I < inputs ? I : 0] : 0)...};
        top(pin(std::get<I>(values), std::is_pointer<Arguments>{})...);
        const std::int32_t results[] = {static_cast<std::int32_t>(std::get<inputs + O>(values))...};
        for (std::size_t i = 0; i < sizeof...(O); ++i) out[i] = results[i];
    }
    template <std::size_t... I>
    static std::uint32_t call(std::uint32_t (*top)(Arguments...), const std::int32_t* in, std::index_sequence<I...>) {
        return top(static_cast<Arguments>(in[I])...);
    }
};

template <class... Arguments>
void call(void (*top)(Arguments...), const std::int32_t* in, std::int32_t* out) {
    using T = Top<Arguments...>;
    T::call(top, in, out, std::index_sequence_for<Arguments...>{},
            std::make_index_sequence<sizeof...(Arguments) - T::inputs>{});
}
template <class... Arguments>
void call(std::uint32_t (*top)(Arguments...), const std::int32_t* in, std::int32_t* out) {
    *out = static_cast<std::int32_t>(Top<Arguments...>::call(top, in, std::index_sequence_for<Arguments...>{}));
}

}  // namespace glint_flat
#define GLINT_FLAT(top) \
    extern "C" void top##_flat(const std::int32_t* in, std::int32_t* out) { glint_flat::call(&top, in, out); }
#endif
