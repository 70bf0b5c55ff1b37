// The units that `glint cost --fpga` can price: lobes, effects, a rival. Their Verilog, and what they answer.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cost/fpga/cost.hpp"
#include "cost/fpga/flow.hpp"
#include "cost/fpga/harness.hpp"
#include "cost/fpga/points.hpp"
#include "glint/golden.hpp"

namespace glint::fpga {

struct PricedUnit {
    Point point;  ///< what it is called; its prices are not filled in
    Unit unit;    ///< as it is instantiated
    Design design;
    std::string family;  ///< devices whose blocks it is built of; empty: any
    bool deep = false;   ///< of an architecture `deep`
    std::vector<Exchange> burst;
    std::shared_ptr<const GoldenModel> rival;  ///< of one: its error is measured when it is priced; null for the lobes
};

/// The units that the options name, of effects where they name any, else of lobes. Throws Error.
std::vector<PricedUnit> priced_units(const Options& options);

}  // namespace glint::fpga
