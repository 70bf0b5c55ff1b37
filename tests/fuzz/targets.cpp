#include "targets.hpp"

#include <algorithm>

namespace glint::fuzz {
namespace {

std::vector<Target>& all() {
    static std::vector<Target> targets;
    return targets;
}

}  // namespace

const std::vector<Target>& targets() { return all(); }

Registration::Registration(std::string_view name, void (*run)(const std::string& text)) {
    all().push_back({name, run});
    std::ranges::sort(all(), {}, &Target::name);
}

}  // namespace glint::fuzz
