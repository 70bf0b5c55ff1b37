// What the report holds against paper 1: errors and shapes of every lobe, the surfaces of f_bps; with the figures of
// the paper as CSV.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "glint/lobes.hpp"
#include "studies/paper.hpp"
#include "studies/report_data.hpp"

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

/// A figure of the paper as CSV, with a heading; where a column has a unit its name ends with it.
struct FigureCsv {
    std::string name;  ///< "figure-5.csv"
    std::string text;
};
std::vector<FigureCsv> figure_csvs(const Curves& curves, const PaperData& data);

}  // namespace glint::studies
