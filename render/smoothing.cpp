#include "smoothing.hpp"

#include <algorithm>
#include <cmath>

namespace glint::render {
namespace {

constexpr double cosine_60 = 0.5;
constexpr std::size_t most_single = 64;

/// Which of 6 x 8 x 8 cells a direction is in.
std::uint32_t cell(const Vec3& v) {
    const double x = std::abs(v.x);
    const double y = std::abs(v.y);
    const double z = std::abs(v.z);
    const auto at = [](double across, double along) {
        return static_cast<std::uint32_t>(std::clamp(4.0 + 4.0 * across / along, 0.0, 7.0));
    };
    if (x >= y && x >= z) return x == 0.0 ? 0U : (v.x < 0.0 ? 0U : 64U) + 8U * at(v.y, x) + at(v.z, x);
    if (y >= z) return (v.y < 0.0 ? 128U : 192U) + 8U * at(v.x, y) + at(v.z, y);
    return (v.z < 0.0 ? 256U : 320U) + 8U * at(v.x, z) + at(v.y, z);
}

}  // namespace

Smoothing::Smoothing(std::span<const std::array<std::uint32_t, 3>> faces, std::span<const Vec3> areas,
                     std::size_t vertices)
    : normals_(3 * faces.size()) {
    // The corners of each vertex, in the order of the faces.
    std::vector<std::size_t> begin(vertices + 1, 0);
    for (const auto& face : faces) {
        for (const std::uint32_t vertex : face) ++begin[vertex + 1];
    }
    for (std::size_t v = 0; v < vertices; ++v) begin[v + 1] += begin[v];
    std::vector<std::size_t> corners(3 * faces.size());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for (std::size_t c = 0; c < corners.size(); ++c) corners[next[faces[c / 3][c % 3]]++] = c;

    struct Group {
        std::uint32_t cell = 0;
        Vec3 sum;
        Vec3 direction;
    };
    std::vector<Group> groups;
    std::vector<std::size_t> group_of;
    std::vector<Vec3> means;
    std::array<std::int32_t, 384> known{};
    for (std::size_t v = 0; v < vertices; ++v) {
        const std::span<const std::size_t> around(corners.data() + begin[v], begin[v + 1] - begin[v]);
        groups.clear();
        const bool single = around.size() <= most_single;
        if (!single) known.fill(-1);
        group_of.clear();
        for (const std::size_t c : around) {
            const Vec3& area = areas[c / 3];
            std::size_t group = groups.size();
            if (!single) {
                std::int32_t& place = known[cell(area)];
                if (place < 0) place = static_cast<std::int32_t>(groups.size());
                group = static_cast<std::size_t>(place);
            }
            if (group == groups.size()) groups.emplace_back();
            groups[group].sum = groups[group].sum + area;
            group_of.push_back(group);
        }
        for (Group& group : groups) group.direction = render::direction(group.sum);
        means.clear();
        for (const Group& own : groups) {
            Vec3 sum;
            for (const Group& other : groups) {
                if (dot(other.direction, own.direction) > cosine_60) sum = sum + other.sum;
            }
            means.push_back(direction(sum));
        }
        comparisons_ += groups.size() * groups.size();
        for (std::size_t i = 0; i < around.size(); ++i) normals_[around[i]] = means[group_of[i]];
    }
}

}  // namespace glint::render
