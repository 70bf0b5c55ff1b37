// A rival of the lobes: c^n from a plain look-up table in block RAM, addressed by the top bits of n and of the cosine.
#pragma once

#include <memory>
#include <vector>

#include <nlohmann/json.hpp>

#include "cost/fpga/flow.hpp"
#include "glint/golden.hpp"

namespace glint::fpga {

/// A table of 2^(n_bits + cos_bits) entries of O bits.
struct TableFormat {
    int n_bits = 0;
    int cos_bits = 0;

    /// The largest table of O-bit entries that both iCE40 devices hold, cut into n and cosine such that the largest
    /// distance to c^n is least.
    static TableFormat best(const Profile& profile);
};

/// What the table answers: the middle between the largest and the least c^n of the inputs that share an entry.
std::unique_ptr<GoldenModel> table_model(const Profile& profile, const TableFormat& format);

/// The contents of the memory, a file that the module reads; then the module `glint_table_P`, a unit with the ports of
/// every other (docs/rtl.md).
Design table_unit(const Profile& profile, const TableFormat& format);

/// {"max", "max_n8": the largest |y / 2^O - c^n| over all legal inputs, and over those with n >= 8; "inputs"}.
nlohmann::ordered_json table_error(const GoldenModel& model);

}  // namespace glint::fpga
