// The golden models for Python: what glint/__init__.py is made of. Arrays are taken as they are, never copied.

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <memory>

#include <fmt/format.h>

#include "glint/effect.hpp"
#include "glint/error.hpp"
#include "glint/lanes.hpp"
#include "glint/lobes.hpp"
#include "glint/sweep.hpp"
#include "glint/vectors.hpp"

namespace nb = nanobind;
using namespace glint;

namespace {

template <class T>
using Array = nb::ndarray<T, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

template <class T>
std::span<T> span_of(const Array<T>& array) {
    return {array.data(), array.shape(0)};
}

/// Throws Error where a code is not in low..high. `what` and `offset` name it.
template <class T>
void check(std::span<const T> codes, std::int64_t low, std::int64_t high, std::string_view what, std::size_t offset) {
    using Word = std::make_unsigned_t<T>;
    constexpr auto sign = static_cast<Word>(Word{1} << (8 * sizeof(T) - 1));
    if (high - low >= std::int64_t{sign} * 2 - 1) return;  // all that T holds
    const auto least = static_cast<Word>(low), most = static_cast<Word>(high);
    Word bad = 0;
    with_lanes([&] {
        Word any = 0;
        // A code out of range makes one of the two differences negative, and one that is legal none: a range is less
        // than half of the codes of T.
        for (const T code : codes) {
            any = static_cast<Word>(any | static_cast<Word>(static_cast<Word>(code) - least) |
                                    static_cast<Word>(most - static_cast<Word>(code)));
        }
        bad = any;
    });
    if ((bad & sign) == 0) return;
    const auto at = std::find_if(codes.begin(), codes.end(), [&](T code) { return code < low || code > high; });
    throw Error(fmt::format("{}[{}] {} is not legal: {} to {}", what,
                            offset + static_cast<std::size_t>(at - codes.begin()), *at, low, high));
}

/// All bits that occur in these words.
std::uint16_t bits_of(std::span<const std::uint16_t> words) {
    std::uint16_t out = 0;
    with_lanes([&] {
        const std::size_t half = words.size() / 2;
        std::uint16_t low = words.size() % 2 != 0 ? words.back() : std::uint16_t{0};
        std::uint16_t high = 0;  // two, so that neither waits for the other
        for (std::size_t i = 0; i < half; ++i) {
            low = static_cast<std::uint16_t>(low | words[i]);
            high = static_cast<std::uint16_t>(high | words[half + i]);
        }
        out = static_cast<std::uint16_t>(low | high);
    });
    return out;
}

/// A lobe at a profile. Its functions let other threads run.
class LobeModel {
public:
    LobeModel(const std::string& name, const std::string& profile) {
        const LobeChoice choice = parse_lobe(name);
        model_ = choice.lobe->golden(choice.profile(profile));
    }
    const GoldenModel& model() const { return *model_; }

    /// Checks and evaluates block by block, while a block is in the cache. After an error `packed` is not to be used.
    /// One n stands for all.
    void eval(const Array<const std::uint16_t>& n, const Array<const std::int32_t>& cos_code,
              const Array<std::uint32_t>& packed, bool ports) const {
        const std::int64_t one = model_->profile().one();
        constexpr std::size_t length = 4096;
        const std::size_t count = packed.shape(0);
        if (cos_code.shape(0) != count || (n.shape(0) != count && n.shape(0) != 1))
            throw Error("lengths of arrays differ");
        const bool one_n = n.shape(0) == 1;
        static_assert(std::has_single_bit(max_n + 1U));  // so that the bits of all n say whether one is too great
        const std::vector<std::uint16_t> same(one_n ? std::min(length, count) : 0,
                                              one_n ? *n.data() : std::uint16_t{1});
        for (std::size_t first = 0; first < count; first += length) {
            const std::size_t size = std::min(length, count - first);
            const auto n_block =
                one_n ? std::span<const std::uint16_t>(same).first(size) : span_of(n).subspan(first, size);
            const auto cos_block = span_of(cos_code).subspan(first, size);
            if ((first == 0 || !one_n) && bits_of(n_block) > max_n) check(n_block, ports ? 0 : 1, max_n, "n", first);
            const auto packed_block = span_of(packed).subspan(first, size);
            const bool corrected = model_->eval_port_batch(n_block, cos_block, packed_block);
            // A model corrects n = 0 and every cosine, and says so. So these checks can wait until the batch has
            // brought the codes into the cache; before it, memory would be waited for twice.
            if (ports) {
                check(cos_block, -2 * one, 2 * one - 1, "cos_code", first);
            } else if (corrected) {
                check(n_block, 1, max_n, "n", first);
                check(cos_block, 0, one, "cos_code", first);
            }
        }
    }

    /// The seconds that the C++ batch alone takes: what a test holds `eval` against.
    double batch_seconds(const Array<const std::uint16_t>& n, const Array<const std::int32_t>& cos_code,
                         const Array<std::uint32_t>& packed) const {
        const auto start = std::chrono::steady_clock::now();
        model_->eval_port_batch(span_of(n), span_of(cos_code), span_of(packed));
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    void reference(double n, const Array<const double>& c, const Array<double>& out) const {
        if (c.shape(0) != out.shape(0)) throw Error("lengths of arrays differ");
        model_->reference(n, span_of(c), span_of(out));
    }

    using Row = std::tuple<int, std::uint64_t, double, int, double, double, int, double, double, int, double, int>;
    /// A row per n, and the total, whose n is 0.
    std::vector<Row> sweep(const std::string& n, const std::string& cos, unsigned threads) const {
        const auto row = [](int at, const Accuracy& a) {
            return Row{at,
                       a.inputs,
                       a.rounding.value,
                       a.rounding.cos_code,
                       a.rounding_rms(),
                       a.approximation.value,
                       a.approximation.cos_code,
                       a.approximation_rms(),
                       a.approximation_exact.value,
                       a.approximation_exact.cos_code,
                       a.epicentre.value,
                       a.epicentre.cos_code};
        };
        const SweepResult result = glint::sweep(*model_, parse_range(n, "n", 1, max_n),
                                                parse_range(cos, "cos", 0, model_->profile().one()), threads);
        std::vector<Row> out;
        for (const AccuracyRow& each : result.rows) out.push_back(row(each.n, each.accuracy));
        out.push_back(row(0, result.total));
        return out;
    }

    std::vector<std::tuple<int, int, std::uint32_t, bool>> vectors(std::size_t count, std::uint64_t seed) const {
        std::vector<std::tuple<int, int, std::uint32_t, bool>> out;
        for (const TestVector& vector : make_vectors(*model_, count, seed)) {
            out.emplace_back(vector.n, vector.cos_code, vector.expected.y, vector.expected.clamped);
        }
        return out;
    }

private:
    std::unique_ptr<GoldenModel> model_;
};

class EffectUnit {
public:
    EffectUnit(const std::string& name, const std::string& profile, const std::string& lobe)
        : effect_(find_effect(name)), model_(effect_.golden(parse_profile(profile), lobe)) {}
    const EffectModel& model() const { return *model_; }

    using Port = std::tuple<std::string, int, bool, int, std::int64_t, std::int64_t>;
    static std::vector<Port> ports(std::span<const EffectPort> ports) {
        std::vector<Port> out;
        for (const EffectPort& p : ports) {
            out.emplace_back(std::string(p.name), p.bits, p.is_signed, p.fraction_bits, p.low, p.high);
        }
        return out;
    }

    void eval(const std::vector<Array<const std::int32_t>>& in, const std::vector<Array<std::int32_t>>& out,
              const Array<std::uint8_t>& clamped) const {
        std::vector<const std::int32_t*> inputs;
        std::vector<std::int32_t*> outputs;
        const std::size_t count = clamped.shape(0);
        for (const auto& column : in) {
            if (column.shape(0) != count) throw Error("lengths of arrays differ");
            if (inputs.size() < model_->inputs().size()) {
                const EffectPort& port = model_->inputs()[inputs.size()];
                check(span_of(column), port.least(), port.greatest(), port.name, 0);
            }
            inputs.push_back(column.data());
        }
        for (const auto& column : out) {
            if (column.shape(0) != count) throw Error("lengths of arrays differ");
            outputs.push_back(column.data());
        }
        model_->eval_port_batch(inputs, outputs, span_of(clamped));
    }

    using Vector = std::tuple<std::vector<std::int64_t>, std::vector<std::int64_t>, bool>;
    std::vector<Vector> vectors(std::size_t count, std::uint64_t seed) const {
        std::vector<Vector> out;
        for (EffectVector& vector : make_vectors(effect_, *model_, count, seed)) {
            out.emplace_back(std::move(vector.in), std::move(vector.expected.values), vector.expected.clamped);
        }
        return out;
    }

private:
    const Effect& effect_;
    std::unique_ptr<EffectModel> model_;
};

std::vector<std::string> names(const auto& list) {
    std::vector<std::string> out;
    for (const auto& each : list) out.emplace_back(each.name);
    return out;
}

}  // namespace

NB_MODULE(_core, module) {
    // An interpreter inside a simulator ends without clearing its modules; that is no leak of ours.
    nb::set_leak_warnings(false);
    using Release = nb::call_guard<nb::gil_scoped_release>;
    nb::exception<Error>(module, "Error", PyExc_ValueError);
    module.attr("version") = GLINT_VERSION;
    module.def("lobes", [] { return names(lobes()); });
    module.def("effects", [] { return names(effects()); });
    const auto profile = [](const auto& self) { return self.model().profile().name; };
    const auto F = [](const auto& self) { return self.model().profile().F; };
    const auto O = [](const auto& self) { return self.model().profile().O; };
    nb::class_<LobeModel>(module, "Lobe")
        .def(nb::init<const std::string&, const std::string&>(), nb::arg("name"), nb::arg("profile"))
        .def_prop_ro("name", [](const LobeModel& self) { return std::string(self.model().lobe()); })
        .def_prop_ro("profile", [=](const LobeModel& self) { return profile(self); })
        .def_prop_ro("F", [=](const LobeModel& self) { return F(self); })
        .def_prop_ro("O", [=](const LobeModel& self) { return O(self); })
        .def("eval", &LobeModel::eval, nb::arg("n").noconvert(), nb::arg("cos_code").noconvert(),
             nb::arg("packed").noconvert(), nb::arg("ports"), Release())
        .def("batch_seconds", &LobeModel::batch_seconds, nb::arg("n").noconvert(), nb::arg("cos_code").noconvert(),
             nb::arg("packed").noconvert(), Release())
        .def("reference", &LobeModel::reference, nb::arg("n"), nb::arg("c").noconvert(), nb::arg("out").noconvert(),
             Release())
        .def("sweep", &LobeModel::sweep, nb::arg("n"), nb::arg("cos"), nb::arg("threads"), Release())
        .def("vectors", &LobeModel::vectors, nb::arg("count"), nb::arg("seed"), Release());
    nb::class_<EffectUnit>(module, "Effect")
        .def(nb::init<const std::string&, const std::string&, const std::string&>(), nb::arg("name"),
             nb::arg("profile"), nb::arg("lobe"))
        .def_prop_ro("name", [](const EffectUnit& self) { return std::string(self.model().effect()); })
        .def_prop_ro("profile", [=](const EffectUnit& self) { return profile(self); })
        .def_prop_ro("F", [=](const EffectUnit& self) { return F(self); })
        .def_prop_ro("O", [=](const EffectUnit& self) { return O(self); })
        .def_prop_ro("inputs", [](const EffectUnit& self) { return EffectUnit::ports(self.model().inputs()); })
        .def_prop_ro("outputs", [](const EffectUnit& self) { return EffectUnit::ports(self.model().outputs()); })
        .def("eval", &EffectUnit::eval, nb::arg("inputs"), nb::arg("outputs"), nb::arg("clamped").noconvert(),
             Release())
        .def("vectors", &EffectUnit::vectors, nb::arg("count"), nb::arg("seed"), Release());
}
