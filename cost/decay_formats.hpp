// Word lengths of the lobe `decay` for an error and a device: the errors by proof, the prices by a model.
#pragma once

#include <vector>

#include "cost/fpga/device.hpp"

namespace glint::cost {

struct DecayFormat {
    std::vector<int> numbers;  ///< of the custom profile: F,A,M,V,H,G,W,n,O
    double bound = 0.0;        ///< of the error against c^n at every legal input: DecayBounds
    double luts = 0.0;         ///< as the model has them; what a synthesis takes is a few per cent off
    int brams = 0;             ///< what a synthesis for an iCE40 takes
};

struct DecaySearch {
    /// First those of which none has fewer LUTs and no more block RAMs, by LUTs; where they are too many, those with
    /// the fewest block RAMs. Then others that are close to them.
    std::vector<DecayFormat> formats;
    int tried = 0;   ///< formats that the device holds
    int proven = 0;  ///< of them, those whose bound was asked for; the others have a price no better than one found
};

/// The formats, at most `most`, whose error is below `max_error`: of one F where it is not 0, else of 16, 17 and 18.
/// `dsp`: products are made of DSPs, where the device has them. Legal: 1e-4 <= max_error <= 0.5.
DecaySearch find_decay_formats(const fpga::Device& device, bool dsp, double max_error, int F, int most);

}  // namespace glint::cost
