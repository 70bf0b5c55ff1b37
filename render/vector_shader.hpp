// Shading through units of the effect `pixel` (docs/effects/pixel.md): vectors, material and light go in, and the pixel
// so far with them; the pixel comes back. Bit-exact units only.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "codes.hpp"
#include "engine.hpp"
#include "geometry.hpp"
#include "glint/shade.hpp"

namespace glint::render {

/// The golden models of Plan::pixels, shared by all threads, and of Plan::units for the names of their parameters.
struct VectorModels {
    std::vector<std::unique_ptr<EffectModel>> pixels, of_unit;

    VectorModels(const Plan& plan, const Profile& profile) {
        const auto make = [&](const std::vector<UnitPlan>& units, auto& out) {
            for (const UnitPlan& unit : units) out.push_back(find_effect(unit.effect).golden(profile, unit.lobe));
        };
        make(plan.pixels, pixels);
        make(plan.units, of_unit);
    }
};

/// Shades blocks of fragments of one material each, on one thread.
class VectorShader {
public:
    VectorShader(const Scene& scene, const Plan& plan, const VectorModels& models, std::span<const Fragment> fragments,
                 const MakeUnit& make_unit)
        : scene_(scene), plan_(plan), models_(models), fragments_(fragments), evaluations_(plan.pixels.size(), 0) {
        for (std::size_t u = 0; u < plan.pixels.size(); ++u) {
            units_.push_back(make_unit(*models.pixels[u], plan.pixels[u].lobe));
        }
    }

    /// `order` are the indices of a block's fragments, all of the material `of`.
    void shade(const MaterialPlan& of, std::span<const std::uint32_t> order, std::vector<Vec3>& pixels) {
        const Material& material = scene_.materials[of.material];
        const EffectModel& model = *models_.pixels[of.pixel];
        const int O = model.profile().O;
        const std::int64_t one = std::int64_t{1} << O;
        count_ = order.size();
        geometry_.load(scene_, fragments_, order, true);
        tags_.resize(count_);
        for (std::size_t i = 0; i < count_; ++i) tags_[i] = fragments_[order[i]].pixel;

        columns_.assign(model.inputs().size(), Column(count_, 0));
        for (std::size_t p = 0; p < columns_.size(); ++p) {
            const EffectPort& port = model.inputs()[p];
            fill(p, std::clamp<std::int64_t>(0, port.low, port.high));
        }
        set_parameters(of, model);
        set_vectors(model, "view", geometry_.view);
        set_vectors(model, "normal", geometry_.normal);
        set_vectors(model, "tangent", geometry_.tangent);
        for (std::size_t i = 0; i < count_; ++i) {
            across_.set(i, cross(geometry_.normal.get(i), geometry_.tangent.get(i)));
        }
        set_vectors(model, "bitangent", across_);
        set_colour(model, "ka", material.ambient, order);
        set_colour(model, "kd", material.diffuse, order);
        set_colour(model, "ks", material.specular, {});

        for (auto& channel : results_) channel.assign(count_, 0);
        if (of.ambient_shown) {
            fill(index(model, "effects"), 1);
            set_colour(model, "ia", scene_.ambient, {});
            evaluate(of.pixel);
        }
        if (material.emission != Vec3{}) add_emission(material, order, one);
        std::int64_t asked = 1;
        const std::vector<std::string_view> names = shade_effects();
        for (const Term& term : of.terms) {
            const auto bit = std::find(names.begin(), names.end(), plan_.units[term.unit].effect) - names.begin();
            asked |= std::int64_t{1} << bit;
        }
        fill(index(model, "effects"), asked);
        for (std::size_t c = 0; c < 3; ++c) fill(index(model, "ka_r") + c, one);
        for (const Light& light : scene_.lights) {
            if (of.terms.empty()) break;
            geometry_.illuminate(light);
            set_vectors(model, "light", geometry_.light);
            const std::size_t i = index(model, "i_r"), ia = index(model, "ia_r");
            const Lane* colour[] = {&geometry_.colour.x, &geometry_.colour.y, &geometry_.colour.z};
            for (std::size_t c = 0; c < 3; ++c) {
                set_lane(model, i + c, *colour[c]);
                columns_[ia + c] = results_[c];  // the pixel so far
            }
            evaluate(of.pixel);
        }
        for (std::size_t i = 0; i < count_; ++i) {
            const auto real = [&](std::size_t c) { return std::ldexp(static_cast<double>(results_[c][i]), -O); };
            pixels[tags_[i]] = {real(0), real(1), real(2)};
        }
    }

    /// Adds what this thread did.
    void report(Shading& out) const {
        for (std::size_t u = 0; u < units_.size(); ++u) {
            out.evaluations[u] += evaluations_[u];
            out.clocks += units_[u]->clocks();
        }
        out.corrected += corrected_;
    }

private:
    using Column = std::vector<std::int32_t>;

    static std::size_t index(const EffectModel& model, std::string_view name) {
        const auto inputs = model.inputs();
        const auto found =
            std::find_if(inputs.begin(), inputs.end(), [&](const EffectPort& port) { return port.name == name; });
        if (found == inputs.end()) throw Error(fmt::format("effect {} has no port {}", model.effect(), name));
        return static_cast<std::size_t>(found - inputs.begin());
    }

    void fill(std::size_t p, std::int64_t code) {
        std::fill(columns_[p].begin(), columns_[p].end(), static_cast<std::int32_t>(code));
    }
    void set_lane(const EffectModel& model, std::size_t p, const Lane& x) {
        codes(model.inputs()[p], {x.data(), count_}, columns_[p].data());
    }
    void set_vectors(const EffectModel& model, std::string_view name, const Lanes& v) {
        const std::size_t p = index(model, fmt::format("{}_x", name));
        set_lane(model, p, v.x);
        set_lane(model, p + 1, v.y);
        set_lane(model, p + 2, v.z);
    }

    /// The exponent, and the parameters by the names of their effects.
    void set_parameters(const MaterialPlan& of, const EffectModel& model) {
        for (const Term& term : of.terms) {
            const EffectModel& effect = *models_.of_unit[term.unit];
            std::size_t next = 0;
            for (const EffectPort& port : effect.inputs()) {
                if (port.kind != EffectPort::Kind::parameter) continue;
                const std::size_t p = index(model, port.name == "n" ? std::string(port.name)
                                                                    : fmt::format("{}_{}", effect.effect(), port.name));
                fill(p, port.code(term.parameters.at(next++)));
            }
        }
    }

    /// A colour; with an order times those of the fragments.
    void set_colour(const EffectModel& model, std::string_view name, const Vec3& k,
                    std::span<const std::uint32_t> order) {
        const std::size_t p = index(model, fmt::format("{}_r", name));
        const double of_channel[3] = {k.x, k.y, k.z};
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t i = 0; i < count_; ++i) {
                lane_[i] = of_channel[c] * (order.empty() ? 1.0 : fragments_[order[i]].colour[c]);
            }
            set_lane(model, p + c, lane_);
        }
    }

    /// No unit makes it: it is part of the pixel so far.
    void add_emission(const Material& material, std::span<const std::uint32_t> order, std::int64_t one) {
        const double of_channel[3] = {material.emission.x, material.emission.y, material.emission.z};
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t i = 0; i < count_; ++i) {
                const double x = of_channel[c] * fragments_[order[i]].colour[c] * static_cast<double>(one);
                results_[c][i] =
                    static_cast<std::int32_t>(std::min<std::int64_t>(one, results_[c][i] + std::llround(x)));
            }
        }
    }

    void evaluate(std::size_t pixel) {
        in_.clear();
        for (const Column& column : columns_) in_.push_back(column.data());
        std::array<std::int32_t*, 3> out{results_[0].data(), results_[1].data(), results_[2].data()};
        units_[pixel]->run(in_, out, tags_, corrected_);
        evaluations_[pixel] += count_;
    }

    const Scene& scene_;
    const Plan& plan_;
    const VectorModels& models_;
    std::span<const Fragment> fragments_;
    std::vector<std::unique_ptr<Unit>> units_;
    std::vector<std::uint64_t> evaluations_;
    std::uint64_t corrected_ = 0;

    std::size_t count_ = 0;
    Geometry geometry_;
    Lanes across_;  ///< to normal and tangent
    Lane lane_;
    std::vector<std::uint32_t> tags_;
    std::vector<Column> columns_;  ///< of each port of the unit
    std::array<Column, 3> results_;
    std::vector<const std::int32_t*> in_;
};

}  // namespace glint::render
