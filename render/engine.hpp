// Shading: every fragment and light through the effects that its material calls for, in blocks on all cores.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "glint/effect.hpp"
#include "glint/parallel.hpp"
#include "image.hpp"
#include "plan.hpp"

namespace glint::render {

/// A bit-exact effect on columns of codes, for one thread.
class Unit {
public:
    virtual ~Unit() = default;
    /// in[p][i] is the code at input port p for evaluation i, out[p][i] the result. Adds to `corrected` the evaluations
    /// in which an input was out of its legal range. `tag` holds the pixel of each evaluation; results that come back
    /// with another are an Error.
    virtual void run(std::span<const std::int32_t* const> in, std::span<std::int32_t* const> out,
                     std::span<const std::uint32_t> tag, std::uint64_t& corrected) = 0;
    /// Clock edges so far, where the unit has a clock.
    virtual std::uint64_t clocks() const { return 0; }
};

/// Brings up a unit of an effect at a profile. Throws Error where there is none.
using MakeUnit = std::function<std::unique_ptr<Unit>(const EffectModel& model, const std::string& lobe)>;

/// The golden model as a unit. The model has to outlive it.
std::unique_ptr<Unit> golden_unit(const EffectModel& model, const std::string& lobe);

struct Shading {
    Picture samples;                         ///< linear, not cut
    std::vector<std::uint64_t> evaluations;  ///< done, in the order of Plan::units, or of Plan::pixels
    std::uint64_t corrected = 0;             ///< evaluations with an input out of its legal range
    std::uint64_t clocks = 0;                ///< of all simulated units
    double seconds = 0.0;
};

/// Shades the fragments; the other pixels show the background. With `make_unit` the sum of the terms is exact, in
/// integers; without (an empty function) everything is in double, by the real functions of the effects. Where the plan
/// has `pixels`, units get the vectors of a fragment and sum the lights, cut to 0 .. 1. The result does not depend on
/// `threads` (0: one a core).
Shading shade(const Scene& scene, const Plan& plan, const std::vector<Fragment>& fragments, int width, int height,
              const Profile& profile, const MakeUnit& make_unit, unsigned threads, const Progress& progress);

}  // namespace glint::render
