// `glint cost --grid`: the word lengths of a lobe that keep the rounding error below the lobe's bound, and what they
// cost; or, of a lobe of tables, the cheapest for an error against c^n.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace glint::cost {

struct GridOptions {
    std::string lobe = "bps";
    int F = 18, O = 12;
    double max_error = 0.0;  ///< against c^n at every n; above 0: O is not used, and F = 0 stands for 16, 17 and 18
    bool dsp = false;        ///< products may be DSPs
    std::string device = "hx8k";
    std::string rtl = "rtl";
    std::string cache = "build/cost-cache";
    std::string json;  ///< merged into this file; may be empty
    int most = 8;      ///< formats that are synthesized, beside the lobe's own
    unsigned jobs = 1, threads = 0;
};

/// The grids of a file that this command wrote, none where the file is not there. Throws Error.
nlohmann::ordered_json read_grids(const std::string& path);

/// The exit status: 1 where no format will do, or a tool fails. Throws Error.
int run_cost_grid(const GridOptions& options);

}  // namespace glint::cost
