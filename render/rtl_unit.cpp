#include "rtl_unit.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "glint/error.hpp"
#include "unit.hpp"

namespace glint::render {
namespace {

class SimulatedUnit final : public Unit {
public:
    SimulatedUnit(std::unique_ptr<testbench::Unit> unit, std::string name)
        : unit_(std::move(unit)), name_(std::move(name)) {}

    void run(std::span<const std::int32_t* const> in, std::span<std::int32_t* const> out,
             std::span<const std::uint32_t> tag, std::uint64_t& corrected) override {
        unit_->run({in, tag}, {}, outcome_);
        clocks_ += outcome_.cycles;
        if (outcome_.results != tag.size() || outcome_.surplus) {
            throw Error(fmt::format("unit {}: {} inputs gave {}{} results", name_, tag.size(),
                                    outcome_.surplus ? "more than " : "", outcome_.results));
        }
        for (std::size_t i = 0; i < tag.size(); ++i) {
            if (outcome_.tags[i] != unit_->expected_tag(tag[i])) {
                throw Error(
                    fmt::format("unit {}: the result of pixel {} came with tag {}", name_, tag[i], outcome_.tags[i]));
            }
            corrected += outcome_.clamped[i];
        }
        for (std::size_t p = 0; p < out.size(); ++p) {
            std::copy_n(outcome_.values[p].begin(), tag.size(), out[p]);
        }
    }

    std::uint64_t clocks() const override { return clocks_; }

private:
    std::unique_ptr<testbench::Unit> unit_;
    std::string name_;
    testbench::Outcome outcome_;
    std::uint64_t clocks_ = 0;
};

}  // namespace

std::string rtl_obstacle(const Plan& plan, const Profile& profile) {
    try {
        const std::vector<UnitPlan>& units = plan.pixels.empty() ? plan.units : plan.pixels;
        for (const UnitPlan& unit : units) testbench::find_effect_unit(unit.effect, unit.lobe, profile.name);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

std::unique_ptr<Unit> rtl_unit(const EffectModel& model, const std::string& lobe) {
    const testbench::UnitKind& kind = testbench::find_effect_unit(model.effect(), lobe, model.profile().name);
    constexpr std::uint64_t seed = 1;  // what registers hold at first must not matter
    return std::make_unique<SimulatedUnit>(kind.make(testbench::input_widths(model), seed),
                                           fmt::format("{} {}", model.effect(), model.profile().name));
}

}  // namespace glint::render
