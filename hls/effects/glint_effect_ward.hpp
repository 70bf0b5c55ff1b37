// glint_effect_ward: the HLS kernel of the effect `ward`. The arithmetic is docs/effects/ward.md.
#ifndef GLINT_EFFECT_WARD_HPP
#define GLINT_EFFECT_WARD_HPP

#include "../blocks/glint_effect.hpp"
#include "../blocks/glint_exp_log.hpp"

#include "../blocks/glint_names_begin.hpp"  // after all others

namespace glint_hls {

/// hx or hy: min(16 - 2^-H, abs(h) k) at H = O + 3 bits. The product is at most 2^F (2^(O+7) - 1), with the half that
/// rounds it still below 128 at F + O bits.
template <int F, int O>
uint<O + 7> ward_scaled(sint<F + 2> h, uint<O + 7> k) {
    constexpr int H = O + 3;
    const uint<F + 1> magnitude = h < 0 ? to_uint<F + 1>(-h) : to_uint<F + 1>(h);
    const uint<F + O + 7> exact = product_u<F + O + 7>(magnitude, k);
    const uint<O + 10> rounded = to_uint<O + 10>(rnd<F + O - H>(exact));
    const uint<O + 10> most = to_uint<O + 10>(to_uint<O + 10>(uint<O + 10>{1} << (H + 4)) - 1U);
    return to_uint<O + 7>(rounded < most ? rounded : most);
}

/// The constants for exp2: its result has 8 integer bits.
template <class Constants>
struct WardPower : Constants {
    static constexpr int O = Constants::O + 8;
};

template <class Constants, class Word>
void effect_ward(std::int32_t nl_port, std::int32_t nv_port, std::int32_t nh_port, std::int32_t ht_port,
                 std::int32_t hb_port, std::uint32_t kx_port, std::uint32_t ky_port, std::int32_t log_peak_port,
                 Word* y, bool* clamped) {
    constexpr int F = Constants::F;
    constexpr int L = Constants::L;
    constexpr int S = Constants::S;
    constexpr int O = Constants::O;
    constexpr int T_W = S + 7;  // bits of r2 and t, below 128

    const Cut<sint<F + 2>> nl = cut_dot<F>(nl_port);
    const Cut<sint<F + 2>> nv = cut_dot<F>(nv_port);
    const Cut<sint<F + 2>> nh = cut_dot<F>(nh_port);
    const Cut<sint<F + 2>> ht = cut_dot<F>(ht_port);
    const Cut<sint<F + 2>> hb = cut_dot<F>(hb_port);
    const uint<O + 7> kx = to_uint<O + 7>(kx_port);
    const uint<O + 7> ky = to_uint<O + 7>(ky_port);
    const sint<S + 5> eight = to_sint<S + 5>(sint<S + 5>{8} << S);
    const sint<S + 5> minus_eight = to_sint<S + 5>(-eight);
    const sint<S + 5> asked = to_sint<S + 5>(log_peak_port);
    const sint<S + 5> log_peak = asked > eight ? eight : asked < minus_eight ? minus_eight : asked;
    *clamped = nl.clamped || nv.clamped || nh.clamped || ht.clamped || hb.clamped || asked != log_peak;

    // In the dark the numbers are those of grazing vectors: in range, and without meaning.
    const bool dark = nl.value <= 0 || nv.value <= 0 || nh.value < 0;
    const uint<F + 1> light = dark ? to_uint<F + 1>(1) : to_uint<F + 1>(nl.value);
    const uint<F + 1> viewer = dark ? to_uint<F + 1>(1) : to_uint<F + 1>(nv.value);
    const uint<F + 1> half = dark ? to_uint<F + 1>(0) : to_uint<F + 1>(nh.value);

    // hx, hy below 16 at O + 3 bits: the sum of their squares is below 512 at 2 O + 6.
    constexpr int R_W = 2 * O + 15;
    const uint<O + 7> hx = ward_scaled<F, O>(ht.value, kx);
    const uint<O + 7> hy = ward_scaled<F, O>(hb.value, ky);
    const uint<R_W> squares = to_uint<R_W>(product_u<R_W>(hx, hx) + product_u<R_W>(hy, hy));
    const uint<T_W + 2> rounded = to_uint<T_W + 2>(rnd<O + 2>(squares));
    const uint<T_W + 2> most = to_uint<T_W + 2>(to_uint<T_W + 2>(uint<T_W + 2>{1} << T_W) - 1U);
    const uint<T_W> r2 = to_uint<T_W>(rounded < most ? rounded : most);

    // r2 2^F / (2^F + nh) as x 2^T_W / D with x <= D: T_W + 1 bits, of which the top one is 0.
    constexpr int up = T_W > F ? T_W - F : 0;
    constexpr int x_up = F > T_W ? F - T_W : 0;
    constexpr int D_W = F + 2 + up;
    const uint<D_W> one = to_uint<D_W>(uint<D_W>{1} << F);
    const uint<D_W> divisor = to_uint<D_W>(to_uint<D_W>(one + to_uint<D_W>(half)) << up);
    const uint<T_W> t = to_uint<T_W>(divide<T_W, D_W>(to_uint<D_W>(to_uint<D_W>(r2) << x_up), divisor));

    // Below 16 in magnitude, with the half that rounds it.
    const sint<L + 6> difference = to_sint<L + 6>(static_cast<sint<L + 6>>(log2<Constants>(light)) -
                                                  static_cast<sint<L + 6>>(log2<Constants>(viewer)));
    const sint<S + 9> w = to_sint<S + 9>(rnd<L + 1 - S>(difference));
    const sint<S + 9> offset = to_sint<S + 9>(w + (to_sint<S + 9>(eight) - to_sint<S + 9>(log_peak)));
    const sint<S + 9> e = to_sint<S + 9>(to_sint<S + 9>(t) + offset);
    const uint<S + 8> exponent = e < 0 ? to_uint<S + 8>(0) : to_uint<S + 8>(e);

    const uint<O + 9> power = exp2<WardPower<Constants>, S + 8>(exponent);
    const uint<O + 8> value = (power >> (O + 8)) != 0 ? to_uint<O + 8>(~uint<O + 8>{0}) : to_uint<O + 8>(power);
    *y = dark ? static_cast<Word>(0) : static_cast<Word>(value);
}

}  // namespace glint_hls

#include "../blocks/glint_names_end.hpp"

#endif
