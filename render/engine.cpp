#include "engine.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <mutex>
#include <numeric>
#include <type_traits>

#include <fmt/format.h>

#include "codes.hpp"
#include "geometry.hpp"
#include "glint/error.hpp"
#include "vector_shader.hpp"

namespace glint::render {
namespace {

/// The golden models of a plan, shared by all threads, and which dot products each reads.
struct Models {
    std::vector<std::unique_ptr<EffectModel>> of_unit;
    std::vector<unsigned> dots;
    const EffectPort* dot_port = nullptr;  // all of one format
    int O;

    Models(const Plan& plan, const Profile& profile) : O(profile.O) {
        for (const UnitPlan& unit : plan.units) {
            of_unit.push_back(find_effect(unit.effect).golden(profile, unit.lobe));
            unsigned mask = 0;
            for (const EffectPort& port : of_unit.back()->inputs()) {
                if (port.kind != EffectPort::Kind::dot) continue;
                mask |= 1U << dot_index(port.name);
                dot_port = &port;
            }
            dots.push_back(mask);
        }
    }
};

class GoldenUnit final : public Unit {
public:
    explicit GoldenUnit(const EffectModel& model) : model_(model) {}
    void run(std::span<const std::int32_t* const> in, std::span<std::int32_t* const> out,
             std::span<const std::uint32_t> tag, std::uint64_t& corrected) override {
        clamped_.resize(tag.size());
        model_.eval_port_batch(in, out, clamped_);
        corrected += std::accumulate(clamped_.begin(), clamped_.end(), std::uint64_t{0});
    }

private:
    const EffectModel& model_;
    std::vector<std::uint8_t> clamped_;
};

/// The real function of an effect on columns.
class RealUnit {
public:
    explicit RealUnit(const EffectModel& model) : model_(model) {}
    void run(std::span<const double* const> in, std::span<double* const> out, std::span<const std::uint32_t> tag,
             std::uint64_t&) {
        arguments_.resize(in.size());
        for (std::size_t i = 0; i < tag.size(); ++i) {
            for (std::size_t p = 0; p < in.size(); ++p) arguments_[p] = in[p][i];
            const std::vector<double> results = model_.reference(arguments_);
            for (std::size_t p = 0; p < out.size(); ++p) out[p][i] = results[p];
        }
    }
    static std::uint64_t clocks() { return 0; }

private:
    const EffectModel& model_;
    std::vector<double> arguments_;
};

/// Shades blocks of fragments of one material each, on one thread. Number is int32 for codes, double for real numbers;
/// either way a block is the same columns, and a sample the same sum of terms.
template <class Number>
class Shader {
public:
    static constexpr bool exact = std::is_integral_v<Number>;
    using Evaluator = std::conditional_t<exact, Unit, RealUnit>;
    using Sum = std::conditional_t<exact, std::int64_t, double>;

    Shader(const Scene& scene, const Plan& plan, const Models& models, std::span<const Fragment> fragments,
           const MakeUnit& make_unit)
        : scene_(scene), plan_(plan), models_(models), fragments_(fragments), evaluations_(plan.units.size(), 0) {
        for (std::size_t u = 0; u < plan.units.size(); ++u) {
            if constexpr (exact) {
                units_.push_back(make_unit(*models.of_unit[u], plan.units[u].lobe));
            } else {
                units_.push_back(std::make_unique<RealUnit>(*models.of_unit[u]));
            }
        }
    }

    /// `order` are the indices of a block's fragments, all of the material `of`.
    void shade(const MaterialPlan& of, std::span<const std::uint32_t> order, std::vector<Vec3>& pixels) {
        const Material& material = scene_.materials[of.material];
        count_ = order.size();
        unsigned wanted = 0;
        for (const Term& term : of.terms) wanted |= models_.dots[term.unit];
        geometry_.load(scene_, fragments_, order, (wanted & (1U << ht | 1U << hb)) != 0);
        tags_.resize(count_);
        for (std::size_t i = 0; i < count_; ++i) tags_[i] = fragments_[order[i]].pixel;

        load_colours(material, order);
        for (auto& channel : sum_) channel.assign(count_, 0);
        if (material.emission != Vec3{}) add_emission(material, order);
        if (of.ambient) {
            fill_colour(light_colour_, light_port(plan_.ambient), scene_.ambient);
            evaluate(plan_.ambient, {&ambient_, &light_colour_}, nullptr, {}, of.ambient_shown);
        }
        for (const Light& light : scene_.lights) {
            if (of.terms.empty()) break;
            geometry_.illuminate(light);
            geometry_.multiply(wanted);
            load_dots(wanted);
            load_light(light);
            for (const Term& term : of.terms) {
                evaluate(term.unit, {}, nullptr, term.parameters, false);
                evaluate(plan_.tint, {term.diffuse ? &diffuse_ : &specular_, &light_colour_}, term_.data(), {},
                         term.shown);
            }
        }
        for (std::size_t i = 0; i < count_; ++i)
            pixels[tags_[i]] = {real(sum_[0][i]), real(sum_[1][i]), real(sum_[2][i])};
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
    using Column = std::vector<Number>;
    using Colour = std::array<Column, 3>;

    static Number number(const EffectPort& port, double x) {
        if constexpr (exact) {
            return static_cast<Number>(port.code(x));
        } else {
            return x;
        }
    }
    void numbers(const EffectPort& port, const Lane& x, Column& out) const {
        out.resize(count_);
        if constexpr (exact) {
            codes(port, {x.data(), count_}, out.data());
        } else {
            std::copy_n(x.begin(), count_, out.begin());
        }
    }

    double real(Sum sum) const {
        if constexpr (exact) {
            return std::ldexp(static_cast<double>(sum), -models_.O);
        } else {
            return sum;
        }
    }

    /// The ports k_r and i_r of an effect that multiplies colours; those of the other channels are like them.
    const EffectPort& colour_port(std::size_t unit, std::string_view name) const {
        for (const EffectPort& port : models_.of_unit[unit]->inputs()) {
            if (port.name == name) return port;
        }
        throw Error(fmt::format("effect {} has no port {}", plan_.units[unit].effect, name));
    }
    const EffectPort& light_port(std::size_t unit) const { return colour_port(unit, "i_r"); }

    void fill(Column& column, Number value) const { column.assign(count_, value); }
    void fill_colour(Colour& colour, const EffectPort& port, const Vec3& value) const {
        fill(colour[0], number(port, value.x));
        fill(colour[1], number(port, value.y));
        fill(colour[2], number(port, value.z));
    }

    /// Ka and Kd times the colour of the fragment; Ks.
    void load_colours(const Material& material, std::span<const std::uint32_t> order) {
        const auto load = [&](Colour& colour, const EffectPort& port, const Vec3& k) {
            const double of_channel[3] = {k.x, k.y, k.z};
            for (std::size_t c = 0; c < 3; ++c) {
                for (std::size_t i = 0; i < count_; ++i) lane_[i] = of_channel[c] * fragments_[order[i]].colour[c];
                numbers(port, lane_, colour[c]);
            }
        };
        if (plan_.ambient != Plan::none) load(ambient_, colour_port(plan_.ambient, "k_r"), material.ambient);
        if (plan_.tint != Plan::none) {
            load(diffuse_, colour_port(plan_.tint, "k_r"), material.diffuse);
            fill_colour(specular_, colour_port(plan_.tint, "k_r"), material.specular);
        }
    }

    void add_emission(const Material& material, std::span<const std::uint32_t> order) {
        for (std::size_t i = 0; i < count_; ++i) {
            const float(&c)[3] = fragments_[order[i]].colour;
            const Vec3 e{material.emission.x * c[0], material.emission.y * c[1], material.emission.z * c[2]};
            const auto add = [&](std::size_t channel, double x) {
                if constexpr (exact) {
                    sum_[channel][i] += std::llround(std::ldexp(x, models_.O));
                } else {
                    sum_[channel][i] += x;
                }
            };
            add(0, e.x);
            add(1, e.y);
            add(2, e.z);
        }
    }

    void load_dots(unsigned wanted) {
        for (std::size_t d = 0; d < dot_names.size(); ++d) {
            if ((wanted >> d & 1U) == 0) continue;
            numbers(*models_.dot_port, geometry_.dots[d], dots_[d]);
        }
    }

    void load_light(const Light& light) {
        const EffectPort& port = light_port(plan_.tint);
        if (light.directional) {
            fill_colour(light_colour_, port, light.colour);
            return;
        }
        numbers(port, geometry_.colour.x, light_colour_[0]);
        numbers(port, geometry_.colour.y, light_colour_[1]);
        numbers(port, geometry_.colour.z, light_colour_[2]);
    }

    /// Runs a unit on the block. Its ports of kind dot, parameter, colour and term are fed from the block's dot
    /// products, `parameters` in order, `colours` (k before i), and `term`. One output is a term and goes to term_;
    /// three are added to the sums where they are to be shown.
    void evaluate(std::size_t unit, std::array<const Colour*, 2> colours, const Number* term,
                  const std::vector<double>& parameters, bool shown) {
        const EffectModel& model = *models_.of_unit[unit];
        in_.clear();
        out_.clear();
        std::size_t next = 0;
        std::size_t channel = 0;
        parameters_.resize(std::max(parameters_.size(), parameters.size()));
        for (const EffectPort& port : model.inputs()) {
            switch (port.kind) {
                case EffectPort::Kind::dot:
                    in_.push_back(dots_[dot_index(port.name)].data());
                    break;
                case EffectPort::Kind::term:
                    in_.push_back(term);
                    break;
                case EffectPort::Kind::colour:
                    in_.push_back((*colours.at(channel / 3))[channel % 3].data());
                    ++channel;
                    break;
                case EffectPort::Kind::parameter:
                    fill(parameters_[next], number(port, parameters.at(next)));
                    in_.push_back(parameters_[next].data());
                    ++next;
                    break;
                case EffectPort::Kind::component:
                    throw Error(fmt::format("{} is not legal in a picture: it takes vectors", model.effect()));
            }
        }
        if (model.outputs().size() == 1) {
            term_.resize(count_);
            out_.push_back(term_.data());
        } else {
            for (auto& column : results_) {
                column.resize(count_);
                out_.push_back(column.data());
            }
        }
        units_[unit]->run(in_, out_, tags_, corrected_);
        evaluations_[unit] += count_;
        if (model.outputs().size() == 1 || !shown) return;
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t i = 0; i < count_; ++i) sum_[c][i] += results_[c][i];
        }
    }

    const Scene& scene_;
    const Plan& plan_;
    const Models& models_;
    std::span<const Fragment> fragments_;
    std::vector<std::unique_ptr<Evaluator>> units_;
    std::vector<std::uint64_t> evaluations_;
    std::uint64_t corrected_ = 0;

    std::size_t count_ = 0;
    Geometry geometry_;
    Lane lane_;
    std::vector<std::uint32_t> tags_;
    std::array<Column, dot_names.size()> dots_;
    Colour ambient_, diffuse_, specular_, light_colour_, results_;
    Column term_;
    std::vector<Column> parameters_;
    std::array<std::vector<Sum>, 3> sum_;
    std::vector<const Number*> in_;
    std::vector<Number*> out_;
};

/// Fragments of one material, at most block_size.
struct Block {
    std::size_t material = 0;  ///< of Plan::materials
    std::size_t begin = 0;     ///< in the order
    std::size_t end = 0;
};

/// Shades the blocks by a Worker for each thread.
template <class Worker, class WorkerModels>
void run_blocks(const Scene& scene, const Plan& plan, const WorkerModels& models, std::span<const Fragment> fragments,
                const MakeUnit& make_unit, std::span<const std::uint32_t> order, std::span<const Block> blocks,
                unsigned threads, const Progress& progress, Shading& out) {
    // The workers are gone when parallel_tasks returns, and with them their counts: they are kept here.
    std::mutex mutex;
    std::vector<std::unique_ptr<Worker>> shaders;
    parallel_tasks(blocks.size(), threads, progress, [&] {
        auto made = std::make_unique<Worker>(scene, plan, models, fragments, make_unit);
        Worker& shader = *made;
        {
            const std::lock_guard lock(mutex);
            shaders.push_back(std::move(made));
        }
        return [&](std::size_t task) {
            const Block& block = blocks[task];
            shader.shade(plan.materials[block.material], order.subspan(block.begin, block.end - block.begin),
                         out.samples.pixels);
        };
    });
    for (const auto& shader : shaders) shader->report(out);
}

}  // namespace

std::unique_ptr<Unit> golden_unit(const EffectModel& model, const std::string&) {
    return std::make_unique<GoldenUnit>(model);
}

Shading shade(const Scene& scene, const Plan& plan, const std::vector<Fragment>& fragments, int width, int height,
              const Profile& profile, const MakeUnit& make_unit, unsigned threads, const Progress& progress) {
    Shading out;
    const bool from_vectors = make_unit && !plan.pixels.empty();
    const std::vector<UnitPlan>& planned = from_vectors ? plan.pixels : plan.units;
    out.evaluations.resize(planned.size());
    out.samples = {width, height, {}};
    for (int y = 0; y < height; ++y) {
        const double t = (y + 0.5) / height;
        const Vec3 colour = (1.0 - t) * scene.background_top + t * scene.background_bottom;
        out.samples.pixels.insert(out.samples.pixels.end(), static_cast<std::size_t>(width), colour);
    }

    // Fragments of a material side by side, in the order of the pixels.
    std::vector<std::size_t> place(scene.materials.size(), 0);
    std::vector<Block> blocks;
    std::size_t total = 0;
    for (std::size_t m = 0; m < plan.materials.size(); ++m) {
        const std::size_t first = total;
        place[plan.materials[m].material] = total;
        total += plan.materials[m].fragments;
        for (std::size_t begin = first; begin < total; begin += block_size) {
            blocks.push_back({m, begin, std::min(begin + block_size, total)});
        }
    }
    std::vector<std::uint32_t> order(fragments.size());
    for (std::size_t f = 0; f < fragments.size(); ++f) {
        order[place[fragments[f].material]++] = static_cast<std::uint32_t>(f);
    }

    const auto run = [&]<class Worker>(const auto& models) {
        run_blocks<Worker>(scene, plan, models, fragments, make_unit, order, blocks, threads, progress, out);
    };
    const auto start = std::chrono::steady_clock::now();
    if (from_vectors) {
        run.template operator()<VectorShader>(VectorModels(plan, profile));
    } else if (make_unit) {
        run.template operator()<Shader<std::int32_t>>(Models(plan, profile));
    } else {
        run.template operator()<Shader<double>>(Models(plan, profile));
    }
    out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    for (std::size_t u = 0; u < planned.size(); ++u) {
        if (out.evaluations[u] != planned[u].evaluations) {
            throw Error(fmt::format("{} evaluations of {} were planned, {} done", planned[u].evaluations,
                                    planned[u].effect, out.evaluations[u]));
        }
    }
    return out;
}

}  // namespace glint::render
