// A Verilated model as a Unit. `Pins` maps the stream onto the names of its ports, and bursts onto what they carry.
#pragma once

#include <verilated.h>
#include <verilated_fst_c.h>

#include <algorithm>
#include <array>
#include <type_traits>

#include "glint/vectors.hpp"
#include "unit.hpp"

namespace glint::testbench {

/// The names that all streams but AXI4-Stream share (docs/rtl.md).
struct StreamPins {
    static constexpr int reset_latency = 0;  ///< clocks until valid and ready have fallen

    template <class Model>
    static void clock(Model& m, bool level) {
        m.clk_i = level;
    }
    template <class Model>
    static void reset(Model& m, bool active) {
        m.rst_ni = !active;
    }
    template <class Model>
    static void input_valid(Model& m, bool valid) {
        m.valid_i = valid;
    }
    template <class Model>
    static bool input_ready(const Model& m) {
        return m.ready_o;
    }
    template <class Model>
    static bool output_valid(const Model& m) {
        return m.valid_o;
    }
    template <class Model>
    static void output_ready(Model& m, bool ready) {
        m.ready_i = ready;
    }
    template <class Model>
    static std::uint32_t output_tag(const Model& m) {
        return m.tag_o;
    }
};

/// What goes in and comes out of the unit of a lobe: n and cos in, one packed word out.
struct LobeTraffic {
    using Burst = testbench::Burst;
    using Outcome = testbench::Outcome;
    using Word = std::uint32_t;

    static void prepare(Outcome& out, std::size_t count) { out.packed.resize(count); }
    static void store(Outcome& out, std::size_t i, Word word) { out.packed[i] = word; }
};

/// Ports of the core: n_i, cos_i, tag_i, y_o, ...
struct CorePins : StreamPins, LobeTraffic {
    explicit CorePins(int F) : cos_mask(~0U >> (30 - F)) {}  // F + 2 bits
    std::uint32_t cos_mask;
    static constexpr std::uint32_t tag(std::uint32_t index) { return index & 0xffffU; }

    template <class Model>
    void input(Model& m, const Burst& burst, std::size_t i) const {
        m.n_i = burst.n[i];
        m.cos_i = static_cast<std::uint32_t>(burst.cos_code[i]) & cos_mask;
        m.tag_i = static_cast<std::uint16_t>(burst.first_tag + i);
    }
    template <class Model>
    static Word word(const Model& m) {
        return static_cast<std::uint32_t>(m.y_o) | static_cast<std::uint32_t>(m.clamped_o) << 31;
    }
};

/// The unit of an effect with `outputs` output ports; which ports those are, CMake reads from its Verilog.
template <std::size_t outputs>
struct EffectPins : StreamPins {
    explicit EffectPins(int) {}
    static constexpr std::uint32_t tag(std::uint32_t tag) { return tag; }

    using Burst = ColumnBurst;
    using Outcome = ColumnOutcome;
    struct Word {
        std::array<std::int32_t, outputs> values{};
        bool clamped = false;
        friend bool operator==(const Word&, const Word&) = default;
    };

    static void prepare(Outcome& out, std::size_t count) {
        out.values.resize(outputs);
        for (auto& column : out.values) column.resize(count);
        out.clamped.resize(count);
    }
    static void store(Outcome& out, std::size_t i, const Word& word) {
        for (std::size_t p = 0; p < outputs; ++p) out.values[p][i] = word.values[p];
        out.clamped[i] = word.clamped;
    }

protected:
    /// The low `bits` of a code.
    template <int bits, class Pin>
    static void set(Pin& pin, std::int32_t code) {
        pin = static_cast<Pin>(static_cast<std::uint32_t>(code) & (~0U >> (32 - bits)));
    }
};

/// Ports of the AXI4-Stream unit. tuser carries the index; tlast one bit of a mix of it, so that neither a stuck nor a
/// shifted tlast goes unseen.
struct AxisPins : LobeTraffic {
    explicit AxisPins(int) {}
    static constexpr int reset_latency = 1;  ///< every output is a register
    static constexpr std::uint32_t last(std::uint32_t index) { return (index * 0x9e37'79b9U) >> 31; }
    static constexpr std::uint32_t tag(std::uint32_t index) { return (index & 0xffffU) | last(index) << 16; }

    template <class Model>
    static void clock(Model& m, bool level) {
        m.aclk = level;
    }
    template <class Model>
    static void reset(Model& m, bool active) {
        m.aresetn = !active;
    }
    template <class Model>
    void input(Model& m, const Burst& burst, std::size_t i) const {
        const auto index = static_cast<std::uint32_t>(burst.first_tag + i);
        // The bits between the fields are ignored by contract: fill them with what would show if they were not.
        const std::uint32_t low = burst.n[i] | (index * 0x85eb'ca6bU & ~0x3ffU);
        m.s_axis_tdata = std::uint64_t{static_cast<std::uint32_t>(burst.cos_code[i])} << 32 | low;
        m.s_axis_tuser = static_cast<std::uint16_t>(index);
        m.s_axis_tlast = last(index) != 0;
    }
    template <class Model>
    static void input_valid(Model& m, bool valid) {
        m.s_axis_tvalid = valid;
    }
    template <class Model>
    static bool input_ready(const Model& m) {
        return m.s_axis_tready;
    }
    template <class Model>
    static bool output_valid(const Model& m) {
        return m.m_axis_tvalid;
    }
    template <class Model>
    static void output_ready(Model& m, bool ready) {
        m.m_axis_tready = ready;
    }
    template <class Model>
    static Word word(const Model& m) {
        return m.m_axis_tdata;
    }
    template <class Model>
    static std::uint32_t output_tag(const Model& m) {
        return m.m_axis_tuser | static_cast<std::uint32_t>(m.m_axis_tlast) << 16;
    }
};

template <class Model, class Pins, bool traced>
class SimulatedUnit final : public StreamUnit<typename Pins::Burst, typename Pins::Outcome> {
public:
    using Burst = typename Pins::Burst;
    using Outcome = typename Pins::Outcome;

    SimulatedUnit(int F, std::uint64_t seed) : pins_(F) {
        // Registers start with random contents: what matters of them must come from reset.
        context_.randReset(2);
        context_.randSeed(static_cast<int>(seed & 0x7fff'ffff) | 1);
        if constexpr (traced) context_.traceEverOn(true);
        model_ = std::make_unique<Model>(&context_);
        Pins::input_valid(*model_, false);
        Pins::output_ready(*model_, false);
        Pins::clock(*model_, false);
        reset();
    }

    ~SimulatedUnit() override {
        if (waveform_) waveform_->close();
        model_->final();
    }

    void reset() override {
        Pins::reset(*model_, true);
        for (int i = 0; i < 4; ++i) {
            settle();
            edge();
        }
        Pins::reset(*model_, false);
        // A ready that is a register rises one clock after reset.
        Pins::input_valid(*model_, false);
        settle();
        edge();
    }

    void run(const Burst& burst, const Schedule& schedule, Outcome& out) override {
        prepare(burst, out);
        clock_ = 0;
        if (schedule.stall_probability > 0.0) {
            run_stalled(burst, schedule, out);
        } else {
            run_full_speed(burst, out);
        }
        Pins::input_valid(*model_, false);
        if (waveform_) {
            waveform_->close();
            waveform_.reset();
        }
    }

    std::string interrupt(const Burst& burst, std::uint64_t at, int length) override {
        clock_ = 0;
        Pins::output_ready(*model_, true);
        Pins::input_valid(*model_, true);
        const auto drive = [&](std::uint64_t i) {
            pins_.input(*model_, burst, i % burst.size());
            settle();
        };
        for (std::uint64_t i = 0; i < at; ++i) {
            drive(i);
            edge();
        }
        Pins::reset(*model_, true);
        for (int i = 0; i < length; ++i) {
            drive(at);
            const bool late = i >= Pins::reset_latency;
            if (late && Pins::output_valid(*model_)) return "valid is not 0 in reset";
            if (late && Pins::input_ready(*model_)) return "ready is not 0 in reset";
            edge();
        }
        Pins::reset(*model_, false);
        Pins::input_valid(*model_, false);
        for (int i = 0; i < silence; ++i) {
            settle();
            if (Pins::output_valid(*model_)) return "a result from before the reset came after it";
            edge();
        }
        if (!Pins::input_ready(*model_)) return "ready stays 0 after reset";
        return {};
    }

    std::uint32_t expected_tag(std::uint32_t tag) const override { return Pins::tag(tag); }

    void trace(const std::string& file, std::uint64_t first, std::uint64_t last) override {
        if constexpr (traced) {
            waveform_ = std::make_unique<VerilatedFstC>();
            model_->trace(waveform_.get(), 99);
            waveform_->open(file.c_str());
            trace_first_ = first;
            trace_last_ = last;
        }
    }

private:
    /// Clocks without any result after which a unit counts as silent: more than the latency of any.
    static constexpr int silence = 256;

    void settle() {
        Pins::clock(*model_, false);
        model_->eval();
        dump(0);
    }
    void edge() {
        Pins::clock(*model_, true);
        model_->eval();
        dump(1);
        ++clock_;
    }
    void dump(std::uint64_t half) {
        if constexpr (traced) {
            if (waveform_ && clock_ >= trace_first_ && clock_ <= trace_last_) waveform_->dump(2 * clock_ + half);
        }
    }

    static void prepare(const Burst& burst, Outcome& out) {
        Pins::prepare(out, burst.size());
        out.tags.resize(burst.size());
        out.results = 0;
        out.surplus = out.unstable = false;
        out.cycles = out.span = 0;
        out.latency = 0;
    }

    void run_full_speed(const Burst& burst, Outcome& out) {
        Model& model = *model_;
        const std::uint32_t count = static_cast<std::uint32_t>(burst.size());
        Pins::output_ready(model, true);
        std::uint32_t sent = 0;
        std::size_t got = 0;
        std::uint64_t first_result = 0;
        std::uint64_t last_result = 0;
        std::uint64_t limit = silence;
        for (std::uint64_t now = 0; now < limit; ++now) {
            const bool valid = sent < count;
            Pins::input_valid(model, valid);
            if (valid) pins_.input(model, burst, sent);
            settle();
            if (Pins::output_valid(model)) {
                if (got == count) {
                    out.surplus = true;
                    break;
                }
                if (got == 0) first_result = now;
                last_result = now;
                Pins::store(out, got, Pins::word(model));
                out.tags[got] = Pins::output_tag(model);
                // After the last, look a little further for what should not come.
                limit = now + 1 + (++got == count ? tail : silence);
            }
            if (valid && Pins::input_ready(model)) ++sent;
            edge();
        }
        out.results = got;
        out.cycles = last_result + 1;
        out.latency = static_cast<int>(first_result);  // the first input is accepted at clock 0
        out.span = got == 0 ? 0 : last_result - first_result + 1;
    }

    void run_stalled(const Burst& burst, const Schedule& schedule, Outcome& out) {
        Model& model = *model_;
        const std::uint32_t count = static_cast<std::uint32_t>(burst.size());
        const auto threshold = static_cast<std::uint32_t>(std::min(schedule.stall_probability * 0x1p32, 4294967295.0));
        Random random(schedule.seed);
        out.clock.resize(count);
        std::uint32_t sent = 0;
        std::size_t got = 0;
        bool offered = false;  // an input was offered and not yet accepted: it has to stay
        bool waiting = false;  // a result had to wait: it has to stay
        typename Pins::Word waiting_word{};
        std::uint32_t waiting_tag = 0;
        int idle = 0;  // clocks since the last transfer in which both sides would have let one happen
        while (idle < (got == count ? tail : silence)) {
            const std::uint64_t draw = random.next();
            const bool valid = sent < count && (offered || static_cast<std::uint32_t>(draw) >= threshold);
            const bool ready = static_cast<std::uint32_t>(draw >> 32) >= threshold;
            Pins::input_valid(model, valid);
            Pins::output_ready(model, ready);
            if (valid) pins_.input(model, burst, sent);
            settle();
            const bool out_valid = Pins::output_valid(model);
            const typename Pins::Word word = Pins::word(model);
            const std::uint32_t tag = Pins::output_tag(model);
            if (waiting && (!out_valid || !(word == waiting_word) || tag != waiting_tag)) out.unstable = true;
            waiting = out_valid && !ready;
            waiting_word = word;
            waiting_tag = tag;
            if (out_valid && ready) {
                if (got == count) {
                    out.surplus = true;
                    break;
                }
                Pins::store(out, got, word);
                out.tags[got] = tag;
                out.clock[got] = clock_;
                ++got;
                out.cycles = clock_ + 1;
            }
            const bool accepted = valid && Pins::input_ready(model);
            offered = valid && !accepted;
            if (accepted) ++sent;
            if (accepted || (out_valid && ready)) {
                idle = 0;
            } else if (ready && (valid || sent == count)) {
                ++idle;
            }
            edge();
        }
        out.results = got;
    }

    static constexpr int tail = 8;  ///< clocks to look on after the last result of a burst

    Pins pins_;
    VerilatedContext context_;
    std::unique_ptr<Model> model_;
    std::unique_ptr<VerilatedFstC> waveform_;
    std::uint64_t clock_ = 0;
    std::uint64_t trace_first_ = 0;
    std::uint64_t trace_last_ = 0;
};

}  // namespace glint::testbench
