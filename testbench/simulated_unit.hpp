// A Verilated model as a Unit. `Pins` maps the stream onto the names of its ports.
#pragma once

#include <verilated.h>

#include <algorithm>
#include <array>

#include "glint/vectors.hpp"
#include "unit.hpp"

#ifdef GLINT_DRAWS
#include <verilated_fst_c.h>
#endif

namespace glint::testbench {

/// What draws the clocks first..last of a burst; nothing does in a unit that is built for speed.
class Waveform {
public:
#ifdef GLINT_DRAWS
    static constexpr bool draws = true;

    void open(auto& model, const std::string& file, std::uint64_t first, std::uint64_t last) {
        fst_ = std::make_unique<VerilatedFstC>();
        model.trace(fst_.get(), 99);
        fst_->open(file.c_str());
        first_ = first;
        last_ = last;
    }
    void dump(std::uint64_t clock, std::uint64_t half) {
        if (fst_ && clock >= first_ && clock <= last_) fst_->dump(2 * clock + half);
    }
    void close() {
        if (fst_) fst_->close();
        fst_.reset();
    }

private:
    std::unique_ptr<VerilatedFstC> fst_;
    std::uint64_t first_ = 0, last_ = 0;
#else
    static constexpr bool draws = false;

    template <class Model>
    void open(Model&, const std::string&, std::uint64_t, std::uint64_t) {}
    void dump(std::uint64_t, std::uint64_t) {}
    void close() {}
#endif
};

template <class Model, class Pins>
class SimulatedUnit final : public Unit {
public:
    /// `bits`: the widths of the inputs, 1 to 32.
    SimulatedUnit(std::span<const int> bits, std::uint64_t seed) {
        for (std::size_t p = 0; p < Pins::inputs; ++p) mask_[p] = ~0U >> (32 - bits[p]);
        // Registers start with random contents, with seed 0 at 0: what matters of them must come from reset.
        context_.randReset(seed == 0 ? 0 : 2);
        context_.randSeed(static_cast<int>(seed & 0x7fff'ffff) | 1);
        if constexpr (Waveform::draws) context_.traceEverOn(true);
        model_ = std::make_unique<Model>(&context_);
        Pins::input_valid(*model_, false);
        Pins::output_ready(*model_, false);
        Pins::clock(*model_, false);
        reset();
    }

    ~SimulatedUnit() override {
        waveform_.close();
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
        waveform_.close();
    }

    std::string interrupt(const Burst& burst, std::uint64_t at, int length) override {
        clock_ = 0;
        Pins::output_ready(*model_, true);
        Pins::input_valid(*model_, true);
        const auto drive = [&](std::uint64_t i) {
            drive_input(burst, i % burst.size());
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
        waveform_.open(*model_, file, first, last);
    }

private:
    /// Clocks without any result after which a unit counts as silent: more than the latency of any.
    static constexpr int silence = 256;

    void settle() {
        Pins::clock(*model_, false);
        model_->eval();
        waveform_.dump(clock_, 0);
    }
    void edge() {
        Pins::clock(*model_, true);
        model_->eval();
        waveform_.dump(clock_, 1);
        ++clock_;
    }

    void drive_input(const Burst& burst, std::size_t i) {
        Pins::input(*model_, burst.inputs.data(), i, mask_.data(), burst.tags[i]);
    }

    static void prepare(const Burst& burst, Outcome& out) {
        out.values.resize(Pins::outputs);
        for (auto& column : out.values) column.resize(burst.size());
        out.clamped.resize(burst.size());
        out.tags.resize(burst.size());
        out.results = 0;
        out.surplus = out.unstable = false;
        out.cycles = out.span = 0;
        out.latency = 0;
    }

    /// What the output shows.
    struct Word {
        std::array<std::int32_t, Pins::outputs> values;
        bool clamped;
        std::uint32_t tag;
        friend bool operator==(const Word&, const Word&) = default;
    };
    Word word() const {
        Word out;
        Pins::output(*model_, out.values.data());
        out.clamped = Pins::clamped(*model_);
        out.tag = Pins::output_tag(*model_);
        return out;
    }
    /// Where words go: the columns of an outcome.
    struct Columns {
        explicit Columns(Outcome& out) : clamped(out.clamped.data()), tags(out.tags.data()) {
            for (std::size_t p = 0; p < Pins::outputs; ++p) values[p] = out.values[p].data();
        }
        void store(std::size_t i, const Word& word) const {
            for (std::size_t p = 0; p < Pins::outputs; ++p) values[p][i] = word.values[p];
            clamped[i] = word.clamped;
            tags[i] = word.tag;
        }
        std::array<std::int32_t*, Pins::outputs> values;
        std::uint8_t* clamped;
        std::uint32_t* tags;
    };

    void run_full_speed(const Burst& burst, Outcome& out) {
        Model& model = *model_;
        const std::uint32_t count = static_cast<std::uint32_t>(burst.size());
        Pins::output_ready(model, true);
        const Columns columns(out);
        std::uint32_t sent = 0;
        std::size_t got = 0;
        std::uint64_t first_result = 0;
        std::uint64_t last_result = 0;
        std::uint64_t limit = silence;
        for (std::uint64_t now = 0; now < limit; ++now) {
            const bool valid = sent < count;
            Pins::input_valid(model, valid);
            if (valid) drive_input(burst, sent);
            settle();
            if (Pins::output_valid(model)) {
                if (got == count) {
                    out.surplus = true;
                    break;
                }
                if (got == 0) first_result = now;
                last_result = now;
                columns.store(got, word());
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
        const Columns columns(out);
        std::uint32_t sent = 0;
        std::size_t got = 0;
        bool offered = false;  // an input was offered and not yet accepted: it has to stay
        bool waiting = false;  // a result had to wait: it has to stay
        Word waiting_word{};
        bool held = true;  // no ready before the first valid, which must not wait for it
        int idle = 0;      // clocks since the last transfer in which both sides would have let one happen
        while (idle < (got == count ? tail : silence)) {
            const std::uint64_t draw = random.next();
            const bool valid = sent < count && (offered || static_cast<std::uint32_t>(draw) >= threshold);
            const bool ready = !held && static_cast<std::uint32_t>(draw >> 32) >= threshold;
            Pins::input_valid(model, valid);
            Pins::output_ready(model, ready);
            if (valid) drive_input(burst, sent);
            settle();
            const bool out_valid = Pins::output_valid(model);
            const Word shown = word();
            held = held && !out_valid;
            if (waiting && (!out_valid || !(shown == waiting_word))) out.unstable = true;
            waiting = out_valid && !ready;
            waiting_word = shown;
            if (out_valid && ready) {
                if (got == count) {
                    out.surplus = true;
                    break;
                }
                columns.store(got, shown);
                out.clock[got] = clock_;
                ++got;
                out.cycles = clock_ + 1;
            }
            const bool accepted = valid && Pins::input_ready(model);
            offered = valid && !accepted;
            if (accepted) ++sent;
            if (accepted || (out_valid && ready)) {
                idle = 0;
            } else if ((ready || held) && (valid || sent == count)) {
                ++idle;
            }
            edge();
        }
        out.results = got;
    }

    static constexpr int tail = 8;  ///< clocks to look on after the last result of a burst

    std::array<std::uint32_t, Pins::inputs> mask_{};  // of the bits of each input
    VerilatedContext context_;
    std::unique_ptr<Model> model_;
    Waveform waveform_;
    std::uint64_t clock_ = 0;
};

}  // namespace glint::testbench
