// What holds for every effect of the registry.
#include "glint/effect.hpp"

#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "catch.hpp"
#include "glint/error.hpp"
#include "glint/vectors.hpp"

using namespace glint;

namespace {

/// What an effect's ports can carry, half of it legal.
std::vector<std::int64_t> random_input(const EffectModel& model, Random& random) {
    std::vector<std::int64_t> in;
    const bool legal = random.next() % 2 == 0;
    for (const EffectPort& port : model.inputs()) {
        in.push_back(legal ? random.between(port.low, port.high) : random.between(port.least(), port.greatest()));
    }
    return in;
}

template <class Check>
void for_all_models(Check check) {
    REQUIRE(!effects().empty());
    for (const Effect& effect : effects()) {
        for (const Profile& profile : shipped_profiles()) {
            INFO(effect.name << " " << profile.name);
            check(effect, *effect.golden(profile, "bps"));
        }
    }
}

}  // namespace

TEST_CASE("an effect has the ports that it says") {
    for_all_models([](const Effect& effect, const EffectModel& model) {
        CHECK(model.effect() == effect.name);
        CHECK(!effect.formula.empty());
        CHECK(!effect.source.empty());
        CHECK(effect.bound_ulp > 0.0);
        std::set<std::string_view> names;
        for (const auto ports : {model.inputs(), model.outputs()}) {
            REQUIRE(!ports.empty());
            for (const EffectPort& port : ports) {
                CAPTURE(port.name);
                CHECK(names.insert(port.name).second);
                CHECK(port.bits >= 1);
                CHECK(port.bits <= (port.is_signed ? 32 : 31));
                CHECK(port.least() <= port.low);
                CHECK(port.low < port.high);
                CHECK(port.high <= port.greatest());
                CHECK(port.code(port.real(port.low)) == port.low);
                CHECK(port.code(port.real(port.high)) == port.high);
            }
        }
    });
}

TEST_CASE("an effect answers within its ports, and its trace ends with the answer") {
    for_all_models([](const Effect& effect, const EffectModel& model) {
        Random random(11);
        std::vector<std::vector<std::int64_t>> inputs;
        std::set<std::string> names;
        for (const EffectCase& c : effect.hard_cases(model)) {
            CAPTURE(c.name);
            CHECK(names.insert(c.name).second);
            CHECK(!c.risk.empty());
            inputs.push_back(c.in);
        }
        CHECK(inputs.size() >= 10);
        for (int i = 0; i < 20000; ++i) inputs.push_back(random_input(model, random));
        std::uint64_t wrong = 0, corrections = 0;
        for (const auto& in : inputs) {
            const EffectResult result = model.eval_port(in);
            const auto trace = model.trace(in);
            REQUIRE(result.values.size() == model.outputs().size());
            REQUIRE(trace.size() > result.values.size());
            const std::size_t first = trace.size() - result.values.size();
            for (std::size_t p = 0; p < result.values.size(); ++p) {
                const EffectPort& port = model.outputs()[p];
                wrong += result.values[p] < port.low || result.values[p] > port.high;
                wrong += trace[first + p].code != result.values[p] || trace[first + p].name != port.name ||
                         trace[first + p].fraction_bits != port.fraction_bits;
            }
            bool clamped = false;
            for (std::size_t p = 0; p < in.size(); ++p) {
                clamped |= in[p] < model.inputs()[p].low || in[p] > model.inputs()[p].high;
            }
            if (effect.name == "cosine" || effect.name.ends_with("_vectors")) {  // a vector of 0
                const std::vector<std::int64_t> none(3);
                clamped |= std::equal(none.begin(), none.end(), in.begin()) ||
                           std::equal(none.begin(), none.end(), in.begin() + 3);
            }
            // shade, alone or in pixel, corrects what is asked for alone: effects_test.cpp.
            if (effect.name != "shade" && effect.name != "pixel") wrong += clamped != result.clamped;
            corrections += clamped;
        }
        CHECK(wrong == 0);
        CHECK(corrections > 0);
        CHECK(corrections < inputs.size());
    });
}

TEST_CASE("an effect is as near to its real function as it says") {
    for_all_models([](const Effect& effect, const EffectModel& model) {
        Random random(12);
        std::vector<std::vector<std::int64_t>> inputs;
        for (const EffectCase& c : effect.hard_cases(model)) inputs.push_back(c.in);
        for (int i = 0; i < 20000; ++i) inputs.push_back(random_input(model, random));
        double worst = 0.0;
        for (const auto& in : inputs) {
            std::vector<double> arguments;
            for (std::size_t p = 0; p < in.size(); ++p) arguments.push_back(model.inputs()[p].real(in[p]));
            const EffectResult result = model.eval_port(in);
            const std::vector<double> real = model.reference(arguments);
            const double scale = model.bound_scale(arguments);
            for (std::size_t p = 0; p < real.size(); ++p) {
                const double error = std::abs(static_cast<double>(result.values[p]) -
                                              std::ldexp(real[p], model.outputs()[p].fraction_bits));
                REQUIRE(std::isfinite(error));
                worst = std::max(worst, error / scale);
            }
        }
        CHECK(worst <= effect.bound_ulp);
        CHECK(worst > 0.0);
    });
}

TEST_CASE("the real function of an effect answers finitely, whatever it is asked") {
    const double infinite = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double values[] = {nan, infinite, -infinite, 0.0, -0.0, 1e300, -1e300, 1e-300, 0.5, 1.0};
    for_all_models([&](const Effect&, const EffectModel& model) {
        Random random(13);
        for (int i = 0; i < 2000; ++i) {
            std::vector<double> in(model.inputs().size());
            for (double& x : in) x = values[random.next() % std::size(values)];
            for (const double y : model.reference(in)) {
                CHECK(std::isfinite(y));
                CHECK((model.outputs()[0].is_signed || y >= 0.0));
            }
            // NaN counts as 0.
            std::vector<double> zeros = in;
            for (double& x : zeros) x = std::isnan(x) ? 0.0 : x;
            CHECK(model.reference(in) == model.reference(zeros));
        }
    });
}

TEST_CASE("columns give what single inputs give") {
    for_all_models([](const Effect&, const EffectModel& model) {
        constexpr std::size_t count = 5000;
        Random random(14);
        std::vector<std::vector<std::int32_t>> in(model.inputs().size(), std::vector<std::int32_t>(count));
        std::vector<std::vector<std::int32_t>> out(model.outputs().size(), std::vector<std::int32_t>(count));
        std::vector<std::uint8_t> clamped(count);
        std::vector<std::vector<std::int64_t>> rows;
        for (std::size_t i = 0; i < count; ++i) {
            rows.push_back(random_input(model, random));
            for (std::size_t p = 0; p < in.size(); ++p) in[p][i] = static_cast<std::int32_t>(rows[i][p]);
        }
        std::vector<const std::int32_t*> inputs;
        std::vector<std::int32_t*> outputs;
        for (const auto& column : in) inputs.push_back(column.data());
        for (auto& column : out) outputs.push_back(column.data());
        model.eval_port_batch(inputs, outputs, clamped);
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < count; ++i) {
            EffectResult row{{}, clamped[i] != 0};
            for (const auto& column : out) row.values.push_back(column[i]);
            wrong += !(row == model.eval_port(rows[i]));
        }
        CHECK(wrong == 0);
        inputs.pop_back();
        CHECK_THROWS_AS(model.eval_port_batch(inputs, outputs, clamped), Error);
    });
}

TEST_CASE("an effect refuses what its ports cannot carry") {
    CHECK_THROWS_AS(find_effect("nosuch"), Error);
    for_all_models([](const Effect&, const EffectModel& model) {
        std::vector<std::int64_t> in;
        for (const EffectPort& port : model.inputs()) in.push_back(port.high);
        CHECK_NOTHROW(model.eval_port(in));
        for (std::size_t p = 0; p < in.size(); ++p) {
            for (const std::int64_t code : {model.inputs()[p].least() - 1, model.inputs()[p].greatest() + 1}) {
                auto illegal = in;
                illegal[p] = code;
                CHECK_THROWS_AS(model.eval_port(illegal), Error);
                CHECK_THROWS_AS(model.trace(illegal), Error);
            }
        }
        in.pop_back();
        CHECK_THROWS_AS(model.eval_port(in), Error);
        CHECK_THROWS_AS(model.reference(std::vector<double>(in.size())), Error);
    });
}

TEST_CASE("a real number becomes the nearest code of its port") {
    const EffectPort port{"x", EffectPort::Kind::dot, 10, true, 8, -256, 256};
    CHECK(port.code(0.5 / 256) == 1);
    CHECK(port.code(-0.5 / 256) == -1);
    CHECK(port.code(0.499 / 256) == 0);
    CHECK(port.code(1.0) == 256);
    CHECK(port.code(1e300) == 511);
    CHECK(port.code(-1e300) == -512);
    CHECK(port.code(std::numeric_limits<double>::infinity()) == 511);
    CHECK(port.code(std::numeric_limits<double>::quiet_NaN()) == 0);
    const EffectPort n{"n", EffectPort::Kind::parameter, 10, false, 0, 1, 1023};
    CHECK(n.code(-3.0) == 0);
    CHECK(n.code(2.5) == 3);
}
