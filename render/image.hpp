// Pictures in linear light, as files, and how far two of them are apart.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "vector.hpp"

namespace glint::render {

struct Picture {
    int width = 0;
    int height = 0;
    std::vector<Vec3> pixels;  ///< linear, row by row from the top
};

/// Every channel cut to 0 .. 1, then the mean of every n x n block.
Picture finish(const Picture& samples, int n);

/// The code of the sRGB transfer function (IEC 61966-2-1) for a linear value in 0 .. 1.
std::uint8_t srgb(double linear);

/// The bytes of an 8-bit RGB PNG file. Throws Error when there is no memory for it.
std::string png(const Picture& picture);

/// How far a finished picture is from another of the same size, as they are shown: in 8-bit sRGB.
struct Distance {
    int largest = 0;            ///< difference of a channel, 0 .. 255
    double psnr = 0.0;          ///< decibel over all channels; infinite when equal
    double ssim = 0.0;          ///< mean structural similarity of the luma; see below
    double largest_linear = 0;  ///< difference of a channel of the linear pictures
    std::uint64_t unequal = 0;  ///< pixels whose bytes differ
};

/// SSIM is that of Wang, Bovik, Sheikh, Simoncelli, "Image Quality Assessment: From Error Visibility to Structural
/// Similarity", IEEE Trans. Image Processing 13 (4), 2004: Gaussian window of 11 x 11 with sigma 1.5, K1 = 0.01,
/// K2 = 0.03, L = 255, on the luma 0.299 R + 0.587 G + 0.114 B, averaged over the windows inside the picture; pictures
/// less than 11 pixels wide or high are one window of equal weights.
Distance compare(const Picture& picture, const Picture& reference);

/// The largest channel of |a - b| in linear light as a colour, from black for 0 in ten steps over red and yellow to
/// white for the largest difference, above a bar that says in numbers what the colours mean; `unit` follows the number:
/// the largest difference is shown as `largest / unit_value`.
Picture difference(const Picture& a, const Picture& b, double unit_value, const std::string& unit);

}  // namespace glint::render
