// What paper 2 is held against: the counted models, its two figures, Phong against Blinn-Phong, and how far
// the modified Cook-Torrance is from the full one.
#pragma once

#include <vector>

#include "studies/paper2.hpp"

namespace glint::studies {

struct Paper2Data {
    std::vector<paper2::CountedModel> models;
    std::vector<paper2::DistributionFigure> distributions;  ///< Fig. 1, by roughness
    std::vector<paper2::ReflectanceFigure> reflectances;    ///< Fig. 2, by index of refraction
    paper2::HighlightFigure highlight;
    std::vector<paper2::Likeness> likeness;  ///< by index, then roughness, then angle of the light

    /// A counted model by its name, which has to be there.
    const paper2::CountedModel& model(std::string_view name) const;
};
Paper2Data paper2_data();

}  // namespace glint::studies
