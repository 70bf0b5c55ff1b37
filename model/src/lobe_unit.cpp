#include "glint/lobe_unit.hpp"

#include <algorithm>

namespace glint {
namespace {

using Kind = EffectPort::Kind;

class LobeUnit final : public EffectModel {
public:
    explicit LobeUnit(const GoldenModel& model)
        : EffectModel(model.lobe(), model.profile(),
                      {{"n", Kind::parameter, 10, false, 0, 1, max_n},
                       {"cos", Kind::dot, model.profile().F + 2, true, model.profile().F, 0, model.profile().one()}},
                      {{"y", Kind::term, model.profile().O + 1, false, model.profile().O, 0,
                        std::int64_t{1} << model.profile().O}}),
          model_(model) {}

private:
    /// The lobe corrects by its own rule; here only whether it does.
    bool correct(std::int64_t* in) const override { return model_.eval_port(static_cast<int>(in[0]), in[1]).clamped; }

    void value(const std::int64_t* in, std::int64_t* out) const override {
        out[0] = model_.eval_port(static_cast<int>(in[0]), in[1]).y;
    }

    void batch(std::span<const std::int32_t* const> inputs, std::span<std::int32_t* const> outputs,
               std::span<std::uint8_t> clamped) const override {
        std::vector<std::uint16_t> n(inputs[0], inputs[0] + clamped.size());
        std::vector<std::uint32_t> packed(clamped.size());
        model_.eval_port_batch(n, {inputs[1], clamped.size()}, packed);
        for (std::size_t i = 0; i < packed.size(); ++i) {
            outputs[0][i] = static_cast<std::int32_t>(packed[i] & 0x7fff'ffffU);
            clamped[i] = static_cast<std::uint8_t>(packed[i] >> 31);
        }
    }

    std::vector<Intermediate> intermediates(const std::int64_t* in) const override {
        return model_.trace(static_cast<int>(in[0]), in[1]);
    }

    void real(const double* in, double* out) const override {
        const double n = std::clamp(in[0], 1.0, static_cast<double>(max_n));
        const double c = std::min(in[1], 1.0);
        out[0] = 0.0;
        if (c >= 0.0) model_.reference(n, {&c, 1}, {out, 1});
    }
    /// `real` has to see that a cosine is negative.
    bool corrects_itself() const override { return true; }

    const GoldenModel& model_;
};

}  // namespace

std::unique_ptr<EffectModel> lobe_unit(const GoldenModel& model) { return std::make_unique<LobeUnit>(model); }

}  // namespace glint
