#include "visibility.hpp"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "glint/error.hpp"

namespace glint::render {
namespace {

template <auto release>
struct Release {
    template <class T>
    void operator()(T* handle) const {
        release(handle);
    }
};
using Device = std::unique_ptr<RTCDeviceTy, Release<rtcReleaseDevice>>;
using Tree = std::unique_ptr<RTCSceneTy, Release<rtcReleaseScene>>;
using Geometry = std::unique_ptr<RTCGeometryTy, Release<rtcReleaseGeometry>>;

/// The triangles in a bounding volume hierarchy.
class Caster {
public:
    explicit Caster(const std::vector<Triangle>& triangles) : device_(rtcNewDevice(nullptr)) {
        if (!device_) throw Error("Embree cannot start on this machine");
        double size = 0.0;
        for (const Triangle& triangle : triangles) {
            for (const Corner& corner : triangle.corners) {
                const Vec3& p = corner.position;
                size = std::max({size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
            }
        }
        scale_ = size > 0.0 ? std::ldexp(1.0, -std::ilogb(size)) : 1.0;
        tree_.reset(rtcNewScene(device_.get()));
        rtcSetSceneFlags(tree_.get(), RTC_SCENE_FLAG_ROBUST);  // no ray slips through between two triangles
        if (!triangles.empty()) {
            const Geometry geometry(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
            auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(
                geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * triangles.size()));
            auto* index = static_cast<std::uint32_t*>(
                rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                        3 * sizeof(std::uint32_t), triangles.size()));
            if (vertex == nullptr || index == nullptr) throw Error("the scene does not fit in memory");
            std::uint32_t next = 0;
            for (const Triangle& triangle : triangles) {
                for (const Corner& corner : triangle.corners) {
                    *vertex++ = scaled(corner.position.x);
                    *vertex++ = scaled(corner.position.y);
                    *vertex++ = scaled(corner.position.z);
                    *index++ = next++;
                }
            }
            rtcCommitGeometry(geometry.get());
            rtcAttachGeometry(tree_.get(), geometry.get());
        }
        rtcCommitScene(tree_.get());
    }

    /// The first triangle on the ray, with the barycentric coordinates of its second and third corner.
    struct Hit {
        std::size_t triangle = none;
        double u = 0.0;
        double v = 0.0;
    };
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

    Hit operator()(const Vec3& from, const Vec3& along) const {
        RTCRayHit query{};
        query.ray.org_x = scaled(from.x);
        query.ray.org_y = scaled(from.y);
        query.ray.org_z = scaled(from.z);
        query.ray.dir_x = static_cast<float>(along.x);
        query.ray.dir_y = static_cast<float>(along.y);
        query.ray.dir_z = static_cast<float>(along.z);
        query.ray.tfar = std::numeric_limits<float>::infinity();
        query.ray.mask = ~0U;
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
        rtcIntersect1(tree_.get(), &query);
#else
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect1(tree_.get(), &context, &query);
#endif
        if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
        return {query.hit.primID, query.hit.u, query.hit.v};
    }

private:
    float scaled(double x) const { return static_cast<float>(scale_ * x); }

    Device device_;
    Tree tree_;
    double scale_ = 1.0;  // a power of two that brings the largest coordinate to 1 .. 2: products fit single precision
};

/// N.V of a pixel that is seen, at least: small beside what a smooth sphere shows, and no 0 in any profile.
constexpr double least_facing = 1.0 / 64.0;

Vec3 between(const Vec3& a, const Vec3& b, const Vec3& c, const Caster::Hit& hit) {
    return (1.0 - hit.u - hit.v) * a + hit.u * b + hit.v * c;
}

void store(float (&out)[3], const Vec3& v) {
    out[0] = static_cast<float>(v.x);
    out[1] = static_cast<float>(v.y);
    out[2] = static_cast<float>(v.z);
}

Fragment fragment(const Triangle& triangle, const Caster::Hit& hit, const Vec3& eye) {
    const auto& [a, b, c] = triangle.corners;
    const Vec3 position = between(a.position, b.position, c.position, hit);
    Vec3 normal = direction(between(a.normal, b.normal, c.normal, hit));
    Vec3 plane = direction(cross(b.position - a.position, c.position - a.position));
    // The side of a surface is what its normals say, not the order of its corners. From behind, it is turned: by the
    // triangle's own plane, since an interpolated normal may turn away at the silhouette without being seen from
    // behind.
    if (normal == Vec3{}) normal = plane;
    if (dot(plane, normal) < 0.0) plane = -plane;
    if (dot(plane, eye - position) < 0.0) normal = -normal;
    // At the silhouette of a model of few faces the interpolated normal turns away from the viewer: bent back, as far
    // as need be, it still has a light to answer to.
    const Vec3 view = direction(eye - position);
    const double facing = dot(normal, view);
    if (facing < least_facing) normal = direction(normal + (least_facing - facing) * view);
    Fragment out;
    out.material = triangle.material;
    store(out.position, position);
    store(out.normal, normal);
    store(out.colour, between(a.colour, b.colour, c.colour, hit));
    return out;
}

}  // namespace

std::vector<Fragment> cast_rays(const Scene& scene, int width, int height, unsigned threads, const Progress& progress) {
    const Caster caster(scene.triangles);
    const Camera& camera = scene.camera;
    std::vector<std::vector<Fragment>> rows(static_cast<std::size_t>(height));
    parallel_tasks(rows.size(), threads, progress, [&] {
        return [&](std::size_t row) {
            const double y = camera.tangent * (1.0 - 2.0 * (static_cast<double>(row) + 0.5) / height);
            for (int column = 0; column < width; ++column) {
                const double x = camera.tangent * (2.0 * (column + 0.5) - width) / height;
                const Vec3 along = direction(camera.forward + x * camera.right + y * camera.up);
                const Caster::Hit hit = caster(camera.eye, along);
                if (hit.triangle == Caster::none) continue;
                Fragment& seen = rows[row].emplace_back(fragment(scene.triangles[hit.triangle], hit, camera.eye));
                seen.pixel = static_cast<std::uint32_t>(row * static_cast<std::size_t>(width)) +
                             static_cast<std::uint32_t>(column);
            }
        };
    });
    std::vector<Fragment> out;
    std::size_t count = 0;
    for (const auto& row : rows) count += row.size();
    out.reserve(count);
    for (auto& row : rows) {
        out.insert(out.end(), row.begin(), row.end());
        row = {};
    }
    return out;
}

const char* ray_caster() {
    static const std::string name = fmt::format("Embree {}", RTC_VERSION_STRING);
    return name.c_str();
}

}  // namespace glint::render
