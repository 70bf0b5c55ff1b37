// The lobe `decay`: docs/lobes/decay.md.

#include "decay_format.hpp"

namespace glint {
namespace {

using exp_log::nearest;
using exp_log::wide_one;

std::vector<int> own_numbers(int F, int O) {
    const int address = std::max(4, O / 2 - 2);
    const int bits = std::max(O, 8);
    return {F, address, bits, bits, address, 2, O > 12 ? 5 : 4, 1, O};
}

/// log2(-ln(1 - d)) at the begin of piece i of octave e, relative to the octave: between 0.4 and 3.5.
exp_log::Wide log_of_log(int A, int e, int i) {
    const int x = (1 << A) + i;
    if (e == 0) return exp_log::log2(exp_log::minus_log_1m(x, A + 1)) + wide_one;
    return exp_log::log2_1p(i, A) + exp_log::log2(exp_log::log_ratio(x, A + 1 + e));
}

}  // namespace

std::vector<DecayFormat::Piece> logarithm_pieces(const DecayFormat& f) {
    const int pieces = 1 << f.A;
    const int last = (1 << f.E) - 1;
    const std::int64_t most = (std::int64_t{1} << f.slope_bits()) - 1;
    std::vector<DecayFormat::Piece> out(std::size_t{1} << (f.E + f.A));
    for (int e = std::min(f.F, last); e >= 0; --e) {
        for (int i = 0; i < pieces; ++i) {
            out[static_cast<std::size_t>(((last - e) << f.A) + i)].base = nearest(log_of_log(f.A, e, i), f.V) + 1;
        }
    }
    for (std::size_t j = 0; j + 1 < out.size(); ++j) {
        const bool ends = (j + 1) % static_cast<std::size_t>(pieces) == 0;
        const std::int64_t next = out[j + 1].base + (ends ? std::int64_t{1} << f.V : 0);
        if (out[j].base != 0) out[j].slope = std::min(next - out[j].base, most);
    }
    out.back().slope = out[out.size() - 2].slope;
    return out;
}

std::vector<DecayFormat::Piece> fall_pieces(const DecayFormat& f) {
    const int count = 1 << (f.W + f.H);
    const std::int64_t most = (std::int64_t{1} << (f.O + f.G)) - 1;
    // 1 - exp(-2^x), x = 4 - 2^W at the begin.
    const auto value = [&](int j) {
        if (j == count) return most;
        const int octave = 4 - (1 << f.W) + (j >> f.H);
        const exp_log::Wide above =
            exp_log::exp2_minus((1 << f.H) - (j & ((1 << f.H) - 1)), f.H);  // 2^(x - octave - 1)
        const exp_log::Wide t = octave + 1 >= 0 ? above << (octave + 1) : above >> -(octave + 1);
        return std::min(nearest(wide_one - exp_log::exp_minus(t), f.O + f.G), most);
    };
    std::vector<DecayFormat::Piece> out(static_cast<std::size_t>(count));
    const int begin = f.first_octave() << f.H;
    for (int j = 0; j < count; ++j) {
        out[static_cast<std::size_t>((begin + j) % count)] = {value(j), value(j + 1) - value(j)};
    }
    return out;
}

std::vector<std::int64_t> exponent_entries(const DecayFormat& f) {
    std::vector<std::int64_t> out;
    for (int m = 0; m < 512; ++m) {
        out.push_back(static_cast<std::int64_t>(exp_log::log2_1p(m, 9) >> (exp_log::wide_bits - f.V)));
    }
    return out;
}

DecayFormat decay_words(const std::vector<int>& x) {
    constexpr std::string_view lobe = DecayFormat::lobe;
    DecayFormat f{x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8], 0, {}, {}, {}};
    in_range(lobe, "F", f.F, 9, 30);
    in_range(lobe, "O", f.O, 4, std::min(28, f.F));
    f.E = static_cast<int>(std::bit_width(static_cast<unsigned>(f.F - 1)));
    in_range(lobe, "A", f.A, 1, 7);
    in_range(lobe, "M", f.M, f.A + 1, f.F - 1);
    in_range(lobe, "G", f.G, 0, 4);
    in_range(lobe, "H", f.H, 1, std::min(8, f.O + f.G - 3));
    in_range(lobe, "V", f.V, std::max(f.A, f.H) + 1, 24);
    in_range(lobe, "W", f.W, 3, f.E);
    in_range(lobe, "n", f.N, 0, 1);
    return f;
}

std::vector<int> decay_numbers(const Profile& profile) {
    if (profile.shipped()) return own_numbers(profile.F, profile.O);
    check_custom(profile, DecayFormat::lobe, "F,A,M,V,H,G,W,n,O");
    return profile.custom;
}

namespace {

DecayFormat decay_format(const Profile& profile) {
    DecayFormat f = decay_words(decay_numbers(profile));
    f.logarithm = logarithm_pieces(f);
    f.fall = fall_pieces(f);
    f.exponent = exponent_entries(f);
    return f;
}

Table piece_table(std::string_view name, std::string module, const std::vector<DecayFormat::Piece>& pieces,
                  int base_bits, int slope_bits) {
    Table out{std::string(name), {{"base", base_bits}, {"slope", slope_bits}}, {}, std::move(module), true, false};
    for (const DecayFormat::Piece& p : pieces) {
        if (p.base < 0 || p.slope < 0 || p.base >> base_bits != 0 || p.slope >> slope_bits != 0) {
            throw Error(
                fmt::format("table {}: {}, {} do not fit {}, {} bits", name, p.base, p.slope, base_bits, slope_bits));
        }
        out.rows.push_back({p.base, p.slope});
    }
    return out;
}

std::vector<GeneratedFile> emit_decay(const Profile& profile, const Architecture& architecture) {
    const DecayFormat f = decay_format(profile);
    const auto text = [](int value) { return std::to_string(value); };
    Table fall =
        piece_table("fall", fmt::format("fall_{}_{}_{}", f.W, f.H, f.O + f.G), f.fall, f.O + f.G, f.step_bits());
    fall.clears = true;
    Table exponent{"exponent", {{"lambda", f.V}}, {}, fmt::format("log2_n_{}_{}", f.exponent.size() << f.N, f.V), true,
                   false};
    if (f.N != 0) exponent.fields.insert(exponent.fields.begin(), {"octave", 4});
    for (int n = f.N != 0 ? 0 : 512; n < 1024; ++n) {
        const int k = static_cast<int>(std::bit_width(static_cast<unsigned>(n | 1))) - 1;
        const std::int64_t lambda = f.exponent[static_cast<std::size_t>(((n | (n == 0)) << (9 - k)) - 512)];
        exponent.rows.push_back(f.N != 0 ? std::vector<std::int64_t>{k + 6, lambda}
                                         : std::vector<std::int64_t>{lambda});
    }
    return generated_sources(
        f.lobe, profile, architecture,
        {{block::stream(), block::step(), block::normalise(f.E), block::entry(), block::rounded(), block::entry(),
          block::rounded(), block::deep()},
         {"glint_delay"}},
        {{"F", text(f.F), ""},
         {"A", text(f.A), ""},
         {"M", text(f.M), ""},
         {"V", text(f.V), ""},
         {"H", text(f.H), ""},
         {"G", text(f.G), ""},
         {"W", text(f.W), ""},
         {"N", text(f.N), ""},
         {"O", text(f.O), ""}},
        {{"int F", text(f.F), "fraction bits of the cosine"},
         {"int A", text(f.A), "address bits of logarithm within an octave"},
         {"int M", text(f.M), "bits of m"},
         {"int V", text(f.V), "fraction bits of w, lambda and x"},
         {"int H", text(f.H), "address bits of fall within an octave"},
         {"int G", text(f.G), "guard bits of fall"},
         {"int W", text(f.W), "address bits of the octave of fall"},
         {"int N", text(f.N), "1: lambda has an entry for each n; 0: for what follows its leading one"},
         {"int O", text(f.O), "fraction bits of the output"},
         {"int E", text(f.E), "bits of e"}},
        {piece_table("logarithm", fmt::format("log_of_log_{}_{}_{}", f.F, f.A, f.V), f.logarithm, f.base_bits(),
                     f.slope_bits()),
         exponent, fall});
}

std::vector<HardCase> decay_hard_cases(const GoldenModel& model) {
    std::vector<HardCase> cases = common_hard_cases(model);
    const int one = model.profile().one();
    cases.push_back({"n = 2, c = 1 ulp", 2, 1, "the last piece of the first octave, whose slope is the one before's"});
    cases.push_back(
        {"n = 3, end of an octave", 3, one / 2, "the end of an octave: d - 1 still has the bits of the one below"});
    cases.push_back({"n = 3, begin of an octave", 3, one / 2 - 1, "the begin of an octave"});
    cases.push_back({"n = 1023, last octave", 1023, one - 2, "d - 1 = 1, the last octave that has a leading one"});
    cases.push_back({"n = 1023, c = 1 - 3 ulp", 1023, one - 3, "one bit of m"});
    for (const int n : {2, 50, 1023}) {
        const int rises = first_code(model, n, "y");
        cases.push_back({fmt::format("n = {}, first result", n), n, rises, "the last octave of fall"});
        if (rises > 0) cases.push_back({fmt::format("n = {}, last 0", n), n, rises - 1, "fall is at its top"});
    }
    return cases;
}

}  // namespace

Lobe decay_lobe() {
    return {"decay",
            "c^n as exp(-2^(log2 n + log2(-ln c)))",
            "F,A,M,V,H,G,W,n,O",
            reference::blinn_phong,
            make_plain<decay_format>,
            emit_decay,
            decay_hard_cases,
            own_numbers,
            {},
            false,
            true,
            false,
            2.0,
            decay_bound};
}

}  // namespace glint
