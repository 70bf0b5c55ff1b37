#include "image.hpp"

#include <png.h>
#include <stb/stb_easy_font.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "glint/error.hpp"

namespace glint::render {
namespace {

Vec3 cut(const Vec3& v) { return {std::clamp(v.x, 0.0, 1.0), std::clamp(v.y, 0.0, 1.0), std::clamp(v.z, 0.0, 1.0)}; }

std::vector<std::uint8_t> bytes(const Picture& picture) {
    std::vector<std::uint8_t> out;
    out.reserve(3 * picture.pixels.size());
    for (const Vec3& p : picture.pixels) {
        out.push_back(srgb(p.x));
        out.push_back(srgb(p.y));
        out.push_back(srgb(p.z));
    }
    return out;
}

/// A plane of numbers, filtered by a window that is the product of one row and one column of weights; only where the
/// whole window lies inside.
struct Plane {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<double> values;
};

Plane filtered(const Plane& in, const std::vector<double>& row, const std::vector<double>& column) {
    Plane across{in.width - row.size() + 1, in.height, {}};
    across.values.resize(across.width * across.height);
    for (std::size_t y = 0; y < across.height; ++y) {
        for (std::size_t x = 0; x < across.width; ++x) {
            double sum = 0.0;
            for (std::size_t k = 0; k < row.size(); ++k) sum += row[k] * in.values[y * in.width + x + k];
            across.values[y * across.width + x] = sum;
        }
    }
    Plane out{across.width, in.height - column.size() + 1, {}};
    out.values.resize(out.width * out.height);
    for (std::size_t y = 0; y < out.height; ++y) {
        for (std::size_t x = 0; x < out.width; ++x) {
            double sum = 0.0;
            for (std::size_t k = 0; k < column.size(); ++k) sum += column[k] * across.values[(y + k) * out.width + x];
            out.values[y * out.width + x] = sum;
        }
    }
    return out;
}

std::vector<double> window(std::size_t length, bool gaussian) {
    std::vector<double> out(length, 1.0);
    if (gaussian) {
        for (std::size_t i = 0; i < length; ++i) {
            const double distance = static_cast<double>(i) - 5.0;
            out[i] = std::exp(-distance * distance / (2.0 * 1.5 * 1.5));
        }
    }
    double sum = 0.0;
    for (const double w : out) sum += w;
    for (double& w : out) w /= sum;
    return out;
}

Plane luma(const Picture& picture, const std::vector<std::uint8_t>& rgb) {
    Plane out{static_cast<std::size_t>(picture.width), static_cast<std::size_t>(picture.height), {}};
    out.values.resize(picture.pixels.size());
    for (std::size_t i = 0; i < out.values.size(); ++i) {
        out.values[i] = 0.299 * rgb[3 * i] + 0.587 * rgb[3 * i + 1] + 0.114 * rgb[3 * i + 2];
    }
    return out;
}

double mean_ssim(const Plane& a, const Plane& b) {
    const bool whole = a.width < 11 || a.height < 11;
    const std::vector<double> row = window(whole ? a.width : 11, !whole);
    const std::vector<double> column = window(whole ? a.height : 11, !whole);
    const auto mean = [&](const auto& value) {
        Plane product{a.width, a.height, std::vector<double>(a.values.size())};
        for (std::size_t i = 0; i < a.values.size(); ++i) product.values[i] = value(a.values[i], b.values[i]);
        return filtered(product, row, column).values;
    };
    const std::vector<double> x = mean([](double p, double) { return p; });
    const std::vector<double> y = mean([](double, double q) { return q; });
    const std::vector<double> xx = mean([](double p, double) { return p * p; });
    const std::vector<double> yy = mean([](double, double q) { return q * q; });
    const std::vector<double> xy = mean([](double p, double q) { return p * q; });
    constexpr double c1 = (0.01 * 255.0) * (0.01 * 255.0);
    constexpr double c2 = (0.03 * 255.0) * (0.03 * 255.0);
    double sum = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double variances = xx[i] - x[i] * x[i] + yy[i] - y[i] * y[i];
        const double covariance = xy[i] - x[i] * y[i];
        sum +=
            (2.0 * x[i] * y[i] + c1) * (2.0 * covariance + c2) / ((x[i] * x[i] + y[i] * y[i] + c1) * (variances + c2));
    }
    return sum / static_cast<double>(x.size());
}

double largest_channel(const Vec3& a, const Vec3& b) {
    const Vec3 d = a - b;
    return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
}

/// Black for 0 alone, then ten steps over red and yellow to white for 1, even as shown. (Few colours make small files.)
Vec3 heat(double x) {
    const double step = std::ceil(10.0 * x) / 10.0;
    const auto channel = [&](double from) { return std::pow(std::clamp(3.0 * step - from, 0.0, 1.0), 2.2); };
    return {channel(0.0), channel(1.0), channel(2.0)};
}

struct Box {
    int x0, y0, x1, y1;
};

void fill(Picture& picture, const Box& box, const Vec3& colour) {
    for (int y = std::max(box.y0, 0); y < std::min(box.y1, picture.height); ++y) {
        for (int x = std::max(box.x0, 0); x < std::min(box.x1, picture.width); ++x) {
            picture.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                           static_cast<std::size_t>(x)] = colour;
        }
    }
}

/// stb_easy_font gives rectangles of four corners each.
void write(Picture& picture, int x, int y, int scale, std::string text) {
    struct Vertex {
        float x, y, z;
        unsigned char colour[4];
    };
    std::vector<Vertex> corners(text.size() * 80 + 4);
    const int count = stb_easy_font_print(0.0F, 0.0F, text.data(), nullptr, corners.data(),
                                          static_cast<int>(corners.size() * sizeof(Vertex)));
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const Vertex& low = corners[4 * i];
        const Vertex& high = corners[4 * i + 2];
        fill(picture,
             {x + scale * static_cast<int>(low.x), y + scale * static_cast<int>(low.y),
              x + scale * static_cast<int>(high.x), y + scale * static_cast<int>(high.y)},
             {0.8, 0.8, 0.8});
    }
}

int text_width(std::string text) { return stb_easy_font_width(text.data()); }

}  // namespace

Picture finish(const Picture& samples, int n) {
    Picture out{samples.width / n, samples.height / n, {}};
    out.pixels.reserve(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            Vec3 sum;
            for (int j = 0; j < n; ++j) {
                const std::size_t row = static_cast<std::size_t>(y * n + j) * static_cast<std::size_t>(samples.width);
                for (int i = 0; i < n; ++i) sum = sum + cut(samples.pixels[row + static_cast<std::size_t>(x * n + i)]);
            }
            out.pixels.push_back(1.0 / (n * n) * sum);
        }
    }
    return out;
}

std::uint8_t srgb(double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255.0 * encoded));
}

std::string png(const Picture& picture) {
    const std::vector<std::uint8_t> rgb = bytes(picture);
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.width);
    image.height = static_cast<png_uint_32>(picture.height);
    image.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = 0;
    std::string out;
    if (png_image_write_to_memory(&image, nullptr, &size, 0, rgb.data(), 0, nullptr) != 0) {
        out.resize(size);
        if (png_image_write_to_memory(&image, out.data(), &size, 0, rgb.data(), 0, nullptr) != 0) {
            out.resize(size);
            return out;
        }
    }
    throw Error(fmt::format("the picture cannot be written as PNG: {}", image.message));
}

Distance compare(const Picture& picture, const Picture& reference) {
    const std::vector<std::uint8_t> a = bytes(picture);
    const std::vector<std::uint8_t> b = bytes(reference);
    Distance out;
    double squares = 0.0;
    for (std::size_t i = 0; i < a.size(); i += 3) {
        bool equal = true;
        for (std::size_t c = i; c < i + 3; ++c) {
            const int d = std::abs(a[c] - b[c]);
            out.largest = std::max(out.largest, d);
            squares += d * d;
            equal = equal && d == 0;
        }
        if (!equal) ++out.unequal;
    }
    out.psnr = squares == 0.0 ? std::numeric_limits<double>::infinity()
                              : 10.0 * std::log10(255.0 * 255.0 * static_cast<double>(a.size()) / squares);
    out.ssim = mean_ssim(luma(picture, a), luma(reference, b));
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        out.largest_linear = std::max(out.largest_linear, largest_channel(picture.pixels[i], reference.pixels[i]));
    }
    return out;
}

Picture difference(const Picture& a, const Picture& b, double unit_value, const std::string& unit) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        largest = std::max(largest, largest_channel(a.pixels[i], b.pixels[i]));
    }
    const int scale = std::max(1, a.width / 480);
    const int bar = 24 * scale;
    Picture out{a.width, a.height + bar, {}};
    out.pixels.reserve(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double d = largest_channel(a.pixels[i], b.pixels[i]);
        out.pixels.push_back(heat(largest == 0.0 ? 0.0 : d / largest));
    }
    out.pixels.resize(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height), {0.02, 0.02, 0.02});
    const std::string left = "0";
    const std::string right = fmt::format("{:.3g} {}", largest / unit_value, unit);
    const int gap = 6 * scale;
    const int top = a.height + 8 * scale;
    const int begin = 2 * gap + scale * text_width(left);
    const int end = out.width - 2 * gap - scale * text_width(right);
    write(out, gap, top, scale, left);
    write(out, end + gap, top, scale, right);
    for (int x = begin; x < end; ++x) {
        fill(out, {x, top - scale, x + 1, top + 8 * scale}, heat((x - begin + 1.0) / (end - begin)));
    }
    return out;
}

}  // namespace glint::render
