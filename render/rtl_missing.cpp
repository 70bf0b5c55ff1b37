// A build without Verilated units.
#include "glint/error.hpp"
#include "rtl_unit.hpp"

namespace glint::render {

std::string rtl_obstacle(const Plan&, const Profile&) {
    return "engine rtl is not in this build, which was made without Verilator (the package `verilator`)";
}

std::unique_ptr<Unit> rtl_unit(const EffectModel& model, const std::string&) {
    throw Error(rtl_obstacle({}, model.profile()));
}

}  // namespace glint::render
