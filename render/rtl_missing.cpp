#include "glint/error.hpp"
#include "rtl_unit.hpp"

namespace glint::render {

bool rtl_available() { return false; }

std::string rtl_missing() {
    return "--engine rtl is not in this build: it needs Verilator (the package `verilator`) and GLINT_COSIM=ON";
}

void check_rtl(const Plan&, const Profile&, bool required) {
    if (required) throw Error(rtl_missing());
}

std::unique_ptr<Unit> rtl_unit(const EffectModel&, const std::string&) { throw Error(rtl_missing()); }

}  // namespace glint::render
