// The one exception of the library: an argument outside its documented range.
#pragma once

#include <stdexcept>

namespace glint {

/// Thrown for an illegal argument. `what()` is one line: which argument, its value, what is legal.
class Error : public std::invalid_argument {
public:
    using std::invalid_argument::invalid_argument;
};

}  // namespace glint
