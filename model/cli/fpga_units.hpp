// The units that `glint cost --fpga` can price: lobes, effects, a rival. Their Verilog, and what they answer.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fpga_cost.hpp"
#include "fpga_flow.hpp"
#include "fpga_harness.hpp"
#include "fpga_points.hpp"
#include "glint/golden.hpp"

namespace glint::cli {

struct PricedUnit {
    FpgaPoint point;            ///< what it is called; its prices are not filled in
    Unit unit;                  ///< as it is instantiated
    std::vector<Source> files;  ///< its own; what they instantiate beside each other is in the folder of the Verilog
    std::vector<Exchange> burst;
    std::shared_ptr<const GoldenModel> rival;  ///< of one: its error is measured when it is priced; null for the lobes
};

/// The units that the options name, of effects where they name any, else of lobes. Throws Error.
std::vector<PricedUnit> priced_units(const FpgaOptions& options);

}  // namespace glint::cli
