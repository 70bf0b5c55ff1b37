// Holds a compiled HLS kernel of an effect against the golden model, bit for bit.
//
//   hls-effect-<compiler> EFFECT PROFILE     all inputs where the ports carry at most 2^20; else the hard cases, then
//                                            2 000 000 random inputs of the ports, seed 1
//
// Exit status: 0 all equal, 1 a difference or no input, 2 bad arguments.
#include <cstdint>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "glint/effect.hpp"
#include "glint/error.hpp"
#include "glint/vectors.hpp"

#include "hls_effect_headers.inc"  // declares the top functions

namespace {

/// What a top function takes its arguments from and writes to.
struct Pins {
    const std::vector<std::int64_t>& in;
    std::vector<std::uint32_t>& out;
    bool clamped = false;
    std::size_t inputs = 0, outputs = 0;

    template <class Argument>
    Argument next() {
        if constexpr (std::is_same_v<Argument, bool*>) {
            return &clamped;
        } else if constexpr (std::is_pointer_v<Argument>) {
            return &out.at(outputs++);
        } else {
            return static_cast<Argument>(in.at(inputs++));
        }
    }
};

template <class... Arguments>
void call(void (*top)(Arguments...), Pins& pins) {
    std::apply(top, std::tuple<Arguments...>{pins.next<Arguments>()...});  // braces: from left to right
}

struct Kernel {
    std::string_view effect;
    std::string_view profile;
    void (*run)(Pins&);
};

// hls_effect_kernels.inc: one GLINT_KERNEL(top, effect, profile) for every kernel that the object files hold.
const Kernel kernels[] = {
#define GLINT_KERNEL(top, effect, profile) {effect, profile, [](Pins& pins) { call(top, pins); }},
#include "hls_effect_kernels.inc"
#undef GLINT_KERNEL
};

class Comparison {
public:
    Comparison(const Kernel& kernel, const glint::EffectModel& model)
        : kernel_(kernel), model_(model), out_(model.outputs().size()) {}

    void run(const std::vector<std::int64_t>& in) {
        const glint::EffectResult want = model_.eval_port(in);
        Pins pins{in, out_};
        kernel_.run(pins);
        ++inputs_;
        bool same = pins.inputs == in.size() && pins.outputs == out_.size() && pins.clamped == want.clamped;
        for (std::size_t p = 0; p < out_.size(); ++p) same = same && out_[p] == want.values[p];
        if (same || ++mismatches_ > 10) return;
        fmt::print("inputs");
        for (const std::int64_t code : in) fmt::print(" {}", code);
        fmt::print(": kernel");
        for (const std::uint32_t code : out_) fmt::print(" {}", code);
        fmt::print(" clamped {}, golden", pins.clamped);
        for (const std::int64_t code : want.values) fmt::print(" {}", code);
        fmt::print(" clamped {}\n", want.clamped);
    }

    int finish() const {
        fmt::print("{} {}: {} inputs, {} mismatches\n", kernel_.effect, kernel_.profile, inputs_, mismatches_);
        return inputs_ > 0 && mismatches_ == 0 ? 0 : 1;
    }

private:
    const Kernel& kernel_;
    const glint::EffectModel& model_;
    std::vector<std::uint32_t> out_;
    std::uint64_t inputs_ = 0, mismatches_ = 0;
};

int test(const Kernel& kernel) {
    const glint::Effect& effect = glint::find_effect(kernel.effect);
    const auto model = effect.golden(glint::parse_profile(kernel.profile), "bps");
    const auto ports = model->inputs();
    Comparison comparison(kernel, *model);
    int bits = 0;
    for (const glint::EffectPort& port : ports) bits += port.bits;
    if (bits <= 20) {
        for (std::int64_t k = 0; k < std::int64_t{1} << bits; ++k) {
            std::vector<std::int64_t> in;
            std::int64_t rest = k;
            for (const glint::EffectPort& port : ports) {
                in.push_back(port.least() + (rest & ((std::int64_t{1} << port.bits) - 1)));
                rest >>= port.bits;
            }
            comparison.run(in);
        }
        return comparison.finish();
    }
    for (const glint::EffectCase& c : effect.hard_cases(*model)) comparison.run(c.in);
    glint::Random random(1);
    std::vector<std::int64_t> in(ports.size());
    for (int i = 0; i < 2000000; ++i) {
        const bool legal = i % 4 != 0;
        for (std::size_t p = 0; p < in.size(); ++p) {
            in[p] = legal ? random.between(ports[p].low, ports[p].high)
                          : random.between(ports[p].least(), ports[p].greatest());
            // Small ones, too, of every size.
            if (i % 2 == 0) in[p] >>= random.between(0, ports[p].bits);
        }
        comparison.run(in);
    }
    return comparison.finish();
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc == 3) {
            for (const Kernel& kernel : kernels) {
                if (kernel.effect == argv[1] && kernel.profile == argv[2]) return test(kernel);
            }
        }
        fmt::print(stderr, "{} arguments or their values are not legal; see the head of effect_kernel.cpp\n", argc - 1);
    } catch (const glint::Error& error) {
        fmt::print(stderr, "{}\n", error.what());
    }
    return 2;
}
