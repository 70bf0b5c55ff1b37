// A top function behind one signature, whatever its ports: an array of its inputs and one of its outputs, in the order
// of the arguments. A result word counts as two outputs, y and clamped.
#ifndef GLINT_FLAT_HPP
#define GLINT_FLAT_HPP

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

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

/// True when a port of this type can carry the number.
template <class T>
bool carries(std::int32_t number) {
    const bool is_signed = !(static_cast<T>(-1) > static_cast<T>(0));
    return static_cast<std::int32_t>(static_cast<T>(number)) == number && (number >= 0 || is_signed);
}

/// The ports of a function of this type. An input is passed by value, an output by pointer.
template <class Function>
struct Ports;

template <class... Arguments>
struct Ports<void(Arguments...)> {
    static constexpr std::size_t inputs = sum(!std::is_pointer<Arguments>::value...);
    static constexpr std::size_t outputs = sizeof...(Arguments) - inputs;
    using Values = std::tuple<std::remove_pointer_t<Arguments>...>;

    /// True when the input ports can carry the numbers.
    static bool carry(const std::int32_t* in) {
        std::size_t i = 0;
        bool all = true;
        for (const bool one :
             {!std::is_pointer<Arguments>::value ? carries<std::remove_pointer_t<Arguments>>(in[i++]) : true...})
            all = all && one;
        return all;
    }
    /// Calls `top`, a function or what can be called like it.
    template <class Top>
    static void call(Top top, const std::int32_t* in, std::int32_t* out) {
        call(top, in, out, std::index_sequence_for<Arguments...>{}, std::make_index_sequence<outputs>{});
    }

private:
    template <class Top, std::size_t... I, std::size_t... O>
    static void call(Top top, const std::int32_t* in, std::int32_t* out, std::index_sequence<I...>,
                     std::index_sequence<O...>) {
        Values values{static_cast<std::tuple_element_t<I, Values>>(I < inputs ? in[I < inputs ? I : 0] : 0)...};
        top(pin(std::get<I>(values), std::is_pointer<Arguments>{})...);
        const std::int32_t results[] = {static_cast<std::int32_t>(std::get<inputs + O>(values))...};
        for (std::size_t i = 0; i < outputs; ++i) out[i] = results[i];
    }
};

template <class... Arguments>
struct Ports<std::uint32_t(Arguments...)> {
    static constexpr std::size_t inputs = sizeof...(Arguments);
    static constexpr std::size_t outputs = 2;

    static bool carry(const std::int32_t* in) { return Ports<void(Arguments...)>::carry(in); }
    template <class Top>
    static void call(Top top, const std::int32_t* in, std::int32_t* out) {
        const std::uint32_t word = call(top, in, std::index_sequence_for<Arguments...>{});
        out[0] = static_cast<std::int32_t>(word & 0x7fffffffU);
        out[1] = static_cast<std::int32_t>(word >> 31);
    }

private:
    template <class Top, std::size_t... I>
    static std::uint32_t call(Top top, const std::int32_t* in, std::index_sequence<I...>) {
        return top(static_cast<Arguments>(in[I])...);
    }
};

}  // namespace glint_flat

/// `<top>_flat(in, out)`, which C calls in one way with whatever types the kernel was compiled.
#define GLINT_FLAT(top)                                                     \
    extern "C" void top##_flat(const std::int32_t* in, std::int32_t* out) { \
        glint_flat::Ports<decltype(top)>::call(top, in, out);               \
    }

#endif
