#include "cost/decay_formats.hpp"

#include <algorithm>

#include "catch.hpp"

using namespace glint::cost;

TEST_CASE("formats of decay for an error: the first ones trade LUTs for block RAMs, all are proven, none is missed") {
    const auto& hx8k = glint::fpga::find_device("hx8k");
    const DecaySearch found = find_decay_formats(hx8k, false, 1.0 / 256, 16, 40);
    REQUIRE(found.formats.size() > 8);
    CHECK(found.proven < found.tried);
    for (const DecayFormat& format : found.formats) {
        CHECK(format.bound < 1.0 / 256);
        CHECK(format.brams <= hx8k.brams);
    }
    const auto first = found.formats.begin();
    const auto close =
        std::is_sorted_until(first, found.formats.end(), [](const auto& a, const auto& b) { return a.luts < b.luts; });
    CHECK(std::is_sorted(first, close, [](const auto& a, const auto& b) { return a.brams > b.brams; }));
    // Units of cost/data/fpga.json: their LUTs within 8 %, their block RAMs exactly.
    struct Priced {
        std::vector<int> numbers;
        int luts, brams;
    };
    for (const Priced& unit :
         {Priced{{16, 4, 8, 8, 4, 1, 4, 0, 9}, 216, 3}, Priced{{16, 5, 7, 8, 5, 1, 4, 1, 9}, 139, 7},
          Priced{{16, 4, 7, 8, 5, 1, 4, 0, 9}, 184, 4}}) {
        const auto format =
            std::find_if(first, found.formats.end(), [&](const DecayFormat& f) { return f.numbers == unit.numbers; });
        REQUIRE(format != found.formats.end());
        CHECK(format->luts == Approx(unit.luts).epsilon(0.08));
        CHECK(format->brams == unit.brams);
    }
    CHECK(find_decay_formats(hx8k, false, 1.0 / 256, 16, 3).formats.size() == 3);
    CHECK(find_decay_formats(hx8k, false, 1e-4, 10, 3).formats.empty());
}
