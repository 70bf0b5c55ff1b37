// The fewest guard bits that keep a promise.
#pragma once

#include <functional>
#include <vector>

#include "glint/lobes.hpp"

namespace glint {

/// The least points of the box low .. high for which `good` holds: each of them is good, and no good point of the box
/// is below it in one coordinate and nowhere above. That is so if `good` never turns false when a coordinate grows;
/// `good` is asked as seldom as that allows. Legal: equal lengths, low <= high.
std::vector<std::vector<int>> minimal_points(const std::vector<int>& low, const std::vector<int>& high,
                                             const std::function<bool(const std::vector<int>&)>& good);

/// Which custom profiles of a lobe are tried: its own numbers at F and O (Lobe::numbers), each word length between
/// them by up to `fewer` bits shorter and up to `more` longer. A number that is no word length stays: its name in
/// Lobe::custom is a small letter.
struct GuardBits {
    int F = 18, O = 12;
    int fewer = 4, more = 1;
    int most = 8;  ///< results wanted: those with the fewest bits in all
};

struct GuardSearch {
    /// Profiles with a rounding error below the lobe's bound (1 ulp for most) at every legal input, the fewest bits
    /// first. None of them has a guard bit to spare: with one less the error reaches the bound, or the profile is not
    /// legal or not among those tried.
    std::vector<Profile> least;
    int tried = 0;     ///< formats that were measured
    int measured = 0;  ///< of them, over every legal input: all that are returned; the others failed on a sample
};

/// Throws Error where F or O is not legal.
GuardSearch find_guard_bits(const Lobe& lobe, const GuardBits& bits, unsigned threads = 0);

}  // namespace glint
