#include "glint/golden.hpp"

#include <fmt/format.h>

#include "glint/error.hpp"

namespace glint {

std::uint32_t GoldenModel::eval(int n, std::int64_t cos_code) const {
    if (n < 1 || n > max_n) throw Error(fmt::format("n {} is not legal: 1 to {}", n, max_n));
    if (cos_code < 0 || cos_code > profile_.one()) {
        throw Error(fmt::format("cos code {} is not legal: 0 to {} (2^{})", cos_code, profile_.one(), profile_.F));
    }
    return value(n, static_cast<std::int32_t>(cos_code));
}

PortResult GoldenModel::eval_port(int n, std::int64_t cos_code) const {
    check_port_range(n, cos_code);
    const Corrected in = correct(n, static_cast<std::int32_t>(cos_code), profile_.one());
    return {in.negative ? 0U : value(in.n, in.cosine), in.clamped};
}

bool GoldenModel::eval_port_batch(std::span<const std::uint16_t> n, std::span<const std::int32_t> cos_code,
                                  std::span<std::uint32_t> packed) const {
    if (n.size() != cos_code.size() || n.size() != packed.size()) {
        throw Error(
            fmt::format("batch lengths {}, {}, {} are not legal: all equal", n.size(), cos_code.size(), packed.size()));
    }
    return !n.empty() && batch(n, cos_code, packed);
}

std::vector<Intermediate> GoldenModel::trace(int n, std::int64_t cos_code) const {
    check_port_range(n, cos_code);
    const Corrected in = correct(n, static_cast<std::int32_t>(cos_code), profile_.one());
    std::vector<Intermediate> out = intermediates(in.n, in.cosine);
    if (in.negative) out.back().code = 0;  // y, the last of every lobe
    return out;
}

void GoldenModel::check_port_range(int n, std::int64_t cos_code) const {
    if (n < 0 || n > max_n) throw Error(fmt::format("n {} is not legal: the port carries 0 to {}", n, max_n));
    const std::int64_t limit = std::int64_t{2} << profile_.F;
    if (cos_code < -limit || cos_code >= limit) {
        throw Error(fmt::format("cos code {} is not legal: the port carries {} to {}", cos_code, -limit, limit - 1));
    }
}

}  // namespace glint
