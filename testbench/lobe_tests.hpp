// The tests of the unit of a lobe.
#pragma once

#include "cosim.hpp"
#include "glint/golden.hpp"
#include "glint/range.hpp"
#include "io/results.hpp"

namespace glint::testbench {

/// What a run of a lobe takes beside a Request. Test::stream sends Request::count random legal inputs, the corners
/// first, or, with a count of 0, this grid, which is measured for accuracy, too; Test::illegal n = 0 with every cosine
/// code and every illegal code with n in {1, 2, 50, 1000, 1023}.
struct Grid {
    Range n{1, max_n, 1};
    Range cos_code{0, 0, 1};
};

/// What determines the results of test_lobe, whatever the shard.
std::string key_of(const UnitKind& kind, const Request& request, const Grid& grid);

/// Runs one test of one unit. Throws Error when there is nothing to run.
io::RunResult test_lobe(const GoldenModel& model, const UnitKind& kind, const Request& request, const Grid& grid,
                        const Progress& progress);

}  // namespace glint::testbench
