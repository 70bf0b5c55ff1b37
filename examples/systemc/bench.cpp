// The unit glint_bps_p12, Verilated as a SystemC module, against the golden model through glint.h: random inputs,
// bubbles and stalls; results in order. `bench [COUNT [SEED]]`; docs/c-api.md has the command that builds it.
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <random>
#include <systemc>

#include "Vglint_bps_p12.h"
#include "glint.h"

struct Bench : sc_core::sc_module {
    // What the ports show for an input, and its tag.
    struct Result {
        uint32_t y;
        bool clamped;
        uint32_t tag;
        bool operator!=(const Result& other) const {
            return y != other.y || clamped != other.clamped || tag != other.tag;
        }
    };

    sc_core::sc_clock clock{"clock", 10, sc_core::SC_NS};
    sc_core::sc_signal<bool> reset_n, valid_in, ready_in, valid_out, ready_out, clamped;
    sc_core::sc_signal<uint32_t> n, cosine, tag_in, y, tag_out;
    Vglint_bps_p12 unit{"unit"};

    glint_model* model;
    std::mt19937 random;
    uint32_t count;
    uint32_t clocks = 0, sent = 0, received = 0, mismatches = 0, progress = 0;
    std::deque<Result> expected;

    SC_HAS_PROCESS(Bench);
    Bench(glint_model* golden, uint32_t inputs, uint32_t seed)
        : sc_module(sc_core::sc_module_name("bench")), model(golden), random(seed), count(inputs) {
        unit.clk_i(clock);
        unit.rst_ni(reset_n);
        unit.valid_i(valid_in);
        unit.ready_o(ready_in);
        unit.n_i(n);
        unit.cos_i(cosine);
        unit.tag_i(tag_in);
        unit.valid_o(valid_out);
        unit.ready_i(ready_out);
        unit.y_o(y);
        unit.tag_o(tag_out);
        unit.clamped_o(clamped);
        SC_METHOD(edge);
        sensitive << clock.posedge_event();
        dont_initialize();
    }

    bool chance(uint32_t percent) { return random() % 100 < percent; }

    void fail(const char* why) {
        std::fprintf(stderr, "bench: %s\n", why);
        ++mismatches;
        sc_core::sc_stop();
    }

    // An input was accepted: 20 bits of two's complement go to the golden model.
    void accepted() {
        Result result{};
        int32_t corrected = 0;
        const int64_t code = cosine.read() < 1U << 19U ? cosine.read() : int64_t(cosine.read()) - (1 << 20);
        if (glint_eval_port(model, int32_t(n.read()), code, &result.y, &corrected) != 0) fail(glint_error());
        result.clamped = corrected != 0;
        result.tag = tag_in;
        expected.push_back(result);
        ++sent;
    }

    void taken() {
        if (expected.empty()) return fail("a result that no input had asked for");
        if (expected.front() != Result{y, clamped, tag_out}) {
            std::fprintf(stderr, "bench: result %u: y %u, expected %u\n", received, y.read(), expected.front().y);
            if (++mismatches == 10) sc_core::sc_stop();
        }
        expected.pop_front();
        progress = clocks;
        ++received;
    }

    // What the signals hold is what the unit sees at this edge; what is written here it sees at the next.
    void edge() {
        reset_n = ++clocks > 3;
        if (reset_n.read()) {
            if (valid_out && ready_out) taken();
            if (valid_in && ready_in) accepted();
        }
        if (clocks > progress + 1000) {  // when all is done, too: nothing may come after the last
            if (sent < count || received < count) fail("no result for 1000 clocks");
            return sc_core::sc_stop();
        }
        if (!valid_in || ready_in) {
            valid_in = reset_n && sent < count && chance(80);
            n = uint32_t(random()) & 0x3ffU;
            // Half of them legal.
            cosine = chance(50) ? uint32_t(random()) % ((1U << 18U) + 1) : uint32_t(random()) & 0xfffffU;
            tag_in = sent & 0xffffU;
        }
        ready_out = chance(70);
    }
};

int sc_main(int argc, char** argv) {
    const unsigned long count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 100000;
    const unsigned long seed = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1;
    if (argc > 3 || count < 1 || count > 1000000000) {
        std::fprintf(stderr, "bench: COUNT '%s' is not legal: 1 to 1000000000, and a seed\n", argc > 1 ? argv[1] : "");
        return 2;
    }
    glint_model* model = glint_open_lobe("bps", "p12");
    if (model == nullptr) {
        std::fprintf(stderr, "bench: %s\n", glint_error());
        return 1;
    }
    Bench bench(model, uint32_t(count), uint32_t(seed));
    sc_core::sc_start();
    std::printf("%u inputs, %u mismatches, seed %lu\n", bench.received, bench.mismatches, seed);
    glint_close(model);
    return bench.mismatches == 0 && bench.received == count ? 0 : 1;
}
