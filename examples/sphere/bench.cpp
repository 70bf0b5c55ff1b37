// The sphere's Verilog against its golden model, clock by clock: every pixel of every picture, and the marks between
// them.
//
// `bench PICTURES [FOLDER]`: as many pictures, the buttons pressed in between; each goes to FOLDER/sphereN.png. make.sh
// builds it: with SPHERE_DVI the module is sphere_dvi, whose bits are decoded, too; else sphere with 4 bits a colour.
// SPHERE_FULL says which sphere_pixel is in it.
#include <png.h>

#include <cstdio>
#include <cstdlib>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "Vtop.h"
#include "golden.hpp"
#include "verilated.h"

namespace {

#ifdef SPHERE_FULL
constexpr sphere::Shading shading = sphere::Shading::full;
#else
constexpr sphere::Shading shading = sphere::Shading::small;
#endif
#ifdef SPHERE_DVI
constexpr int bits = 8;
#else
constexpr int bits = 4;
#endif

/// The three channels of DVI as a monitor takes them: words found by the clock's channel, then decoded.
class Receiver {
public:
    /// Two bits of each of four channels, the clock's the last. True where they end a word.
    bool take(unsigned first, unsigned second) {
        bool whole = false;
        for (const unsigned pair : {first, second}) {
            const bool clock = (pair >> 3 & 1U) != 0;
            if (clock && !clock_) {  // a rising edge: a word begins
                whole = place_ == 10;
                if (whole) words_ = shift_;
                place_ = 0;
            }
            clock_ = clock;
            if (place_ < 10) {
                for (unsigned c = 0; c < 3; ++c) {
                    shift_[c] = (place_ == 0 ? 0 : shift_[c]) | (pair >> c & 1U) << place_;
                }
            }
            ++place_;
        }
        return whole;
    }

    /// What the last words say.
    sphere::Output output() {
        sphere::Output out;
        static constexpr unsigned control[] = {0x354, 0x0ab, 0x154, 0x2ab};  // for vsync, hsync: 00, 01, 10, 11
        for (unsigned c = 0; c < 4; ++c) {
            if (words_[0] != control[c]) continue;
            out.hsync = (c & 1U) == 0;  // the wires are active low
            out.vsync = (c & 2U) == 0;
            balance_ = {};
            if (words_[1] != control[0] || words_[2] != control[0]) ++faults;
            return out;
        }
        out.visible = true;
        for (unsigned c = 0; c < 3; ++c) {
            const unsigned word = words_[c];
            const unsigned data = (word ^ ((word & 0x200U) != 0 ? 0xffU : 0U)) & 0xffU;
            const unsigned links = (data ^ data << 1U ^ ((word & 0x100U) != 0 ? 0U : 0xfeU)) & 0xffU;
            out.colour[2 - c] = int(links);  // blue is the first
            balance_[c] += 2 * __builtin_popcount(word) - 10;
            if (std::abs(balance_[c]) > 10) ++faults;  // never more than a word of ones too many
        }
        return out;
    }

    int faults = 0;

private:
    bool clock_ = true;
    int place_ = 0;
    std::array<unsigned, 3> shift_{}, words_{};
    std::array<int, 3> balance_{};
};

class Bench {
public:
    explicit Bench(int pictures) : pictures_(pictures) {
        top_.rst_ni = 0;
        for (int i = 0; i < 200; ++i) clock(false);  // what was in the pipeline leaves it
        top_.rst_ni = 1;
    }

    /// False when a clock's output was wrong; at most ten are told.
    bool run(const std::string& folder) {
        int wait = 0;
        while (!top_.visible_o) {
            clock(false);
            if (++wait > 1000) return fail("no picture after 1000 clocks");
        }
        for (int p = 0; p < pictures_; ++p) {
            const sphere::Buttons buttons{p % 2 == 1, p % 8 == 2, p % 8 == 4};
            press(buttons);
            std::vector<unsigned char> image;
            for (int v = 0; v < 525; ++v) {
                for (int h = 0; h < 800; ++h) compare(p, h, v, image);
                if (wrong_ > 10) return false;
            }
            golden_.next_picture(buttons);
            if (!folder.empty()) write(folder + "/sphere" + std::to_string(p) + ".png", image);
        }
        if (receiver_.faults != 0) fail("words of DVI that no sender makes: " + std::to_string(receiver_.faults));
        std::printf("%d pictures, %ld clocks", pictures_, compared_);
#ifdef SPHERE_DVI
        if (received_ < compared_ - 10) fail("clocks that DVI has not sent");
        std::printf(" and as many words of DVI");
#endif
        std::printf(": %d differ\n", wrong_);
        return wrong_ == 0;
    }

private:
    bool fail(const std::string& why) {
        if (++wrong_ <= 10) std::fprintf(stderr, "bench: %s\n", why.c_str());
        return false;
    }

    void press(const sphere::Buttons& buttons) {
        top_.next_i = buttons.next;
        top_.hold_turn_i = buttons.hold_turn;
        top_.hold_light_i = buttons.hold_light;
    }

    /// One clock of pixels; five of bits. What DVI sends goes to `sent_`'s front once anything is expected.
    void clock(bool expecting) {
        for (int k = 0; k < 5; ++k) {
            top_.clk_i = k == 0 ? 1 : k == 3 ? 0 : top_.clk_i;
#ifdef SPHERE_DVI
            top_.clk_shift_i = 1;
            top_.eval();
            const bool whole = receiver_.take(top_.first_o, top_.second_o);
            top_.clk_shift_i = 0;
            if (whole) check(expecting);
#else
            (void)expecting;
            if (k != 0 && k != 3) continue;
#endif
            top_.eval();
        }
    }

    /// A word of DVI has come: that of the oldest output which has none yet.
    void check(bool expecting) {
        const sphere::Output output = receiver_.output();
        if (!started_) started_ = expecting && output.visible;
        if (!started_ || sent_.empty()) return;
        if (output != sent_.front())
            fail("DVI sends another pixel or mark than went in, word " + std::to_string(received_));
        sent_.pop_front();
        ++received_;
    }

    /// The output of this clock, which is then over.
    void compare(int picture, int h, int v, std::vector<unsigned char>& image) {
        const sphere::Output expected = golden_.at(h, v);
        sphere::Output output;
        output.hsync = !top_.hsync_o;
        output.vsync = !top_.vsync_o;
        output.visible = top_.visible_o;
        output.colour = {top_.r_o, top_.g_o, top_.b_o};
        if (output != expected) {
            fail("picture " + std::to_string(picture) + ", line " + std::to_string(v) + ", clock " + std::to_string(h) +
                 ": " + text(output) + ", expected " + text(expected));
        }
        if (output.visible) {
            for (const int channel : output.colour)
                image.push_back(static_cast<unsigned char>(channel * 255 / ((1 << bits) - 1)));
        }
        sent_.push_back(expected);
        if (sent_.size() > 100) sent_.pop_front();
        ++compared_;
        clock(true);
    }

    static std::string text(const sphere::Output& o) {
        return std::string(o.hsync ? "h" : "-") + (o.vsync ? "v" : "-") + (o.visible ? "d " : "- ") +
               std::to_string(o.colour[0]) + " " + std::to_string(o.colour[1]) + " " + std::to_string(o.colour[2]);
    }

    void write(const std::string& path, const std::vector<unsigned char>& image) {
        png_image png{};
        png.version = PNG_IMAGE_VERSION;
        png.width = 640;
        png.height = 480;
        png.format = PNG_FORMAT_RGB;
        if (image.size() != 640 * 480 * 3 ||
            png_image_write_to_file(&png, path.c_str(), 0, image.data(), 0, nullptr) == 0) {
            fail("cannot write " + path);
        }
    }

    int pictures_;
    VerilatedContext context_;
    Vtop top_{&context_};
    sphere::Golden golden_{"examples/sphere/materials.hex", shading, bits};
    Receiver receiver_;
    std::deque<sphere::Output> sent_;
    bool started_ = false;
    long compared_ = 0, received_ = 0;
    int wrong_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
    const int pictures = argc > 1 ? std::atoi(argv[1]) : 0;
    if (argc > 3 || pictures < 1 || pictures > 1000) {
        std::fprintf(stderr, "bench: PICTURES '%s' is not legal: 1 to 1000, and a folder\n", argc > 1 ? argv[1] : "");
        return 2;
    }
    try {
        return Bench(pictures).run(argc > 2 ? argv[2] : "") ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench: %s\n", error.what());
        return 1;
    }
}
