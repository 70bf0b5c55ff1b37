// What a function is refused with.
#pragma once

#include <string>

#include "glint/error.hpp"

namespace glint {

/// The text of the Error that it throws; empty: none.
template <class Function>
std::string refusal(const Function& function) {
    try {
        function();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

}  // namespace glint
