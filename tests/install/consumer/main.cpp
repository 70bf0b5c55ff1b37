#include <cstdio>

#include "glint/lobes.hpp"

int main() {
    const auto model = glint::find_lobe("bps").golden(glint::parse_profile("p12"));
    std::printf("%u\n", model->eval(50, 256901));
}
