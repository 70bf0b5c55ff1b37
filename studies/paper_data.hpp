// What paper 1 is held against: errors and shapes of every lobe, the surfaces of f_bps.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "glint/lobes.hpp"
#include "studies/curves.hpp"
#include "studies/paper.hpp"

namespace glint::studies {

/// A lobe as a real function.
struct StudiedLobe {
    const Lobe* lobe = nullptr;
    Study study;
    double peak = 0.0;   ///< at c = 1
    double floor = 0.0;  ///< at c = 0 and shape_n
    /// Where it is 0 over the angle at shape_n, in degrees, and the value that it falls from there.
    struct Zero {
        double from, to, drop;
    };
    std::optional<Zero> zero;

    bool exact() const;  ///< c^n itself, but for the last bits of double
};
inline constexpr int shape_n = 50;

/// A function of n and of an angle, on a grid even in log n.
struct Surface {
    std::size_t columns = 240;
    std::size_t rows = 160;
    double first_n = 1.0;
    std::vector<double> n;      ///< a column's; real numbers
    std::vector<double> theta;  ///< row after row, radians
    std::vector<double> value;
    double largest = 0.0, largest_n = 0.0, largest_theta = 0.0;
};

struct PaperData {
    std::vector<StudiedLobe> lobes;  ///< the paper's five in its order, then the others by name
    std::size_t of_paper = 0;        ///< so many are the paper's
    Surface highlight;               ///< f_bps; rows even in the log of the angle
    Surface delta;                   ///< relative error of f_bps; rows even in the fraction of the epicentre zone
    Surface absolute;                ///< absolute error of f_bps; rows as of `highlight`

    const StudiedLobe& lobe(std::string_view name) const;
};
PaperData paper_data();

}  // namespace glint::studies
