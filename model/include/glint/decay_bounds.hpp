// Proven bounds of the error of the lobe `decay`, for many word lengths at once.
#pragma once

#include <map>
#include <vector>

namespace glint {

/// What two profiles have in common is computed once: a search asks for a hundred thousand of them.
class DecayBounds {
public:
    /// A number that |y / 2^O - c^n| is not above, at any legal input: docs/lobes/decay.md, "Proof". `numbers` are
    /// those of a custom profile, F,A,M,V,H,G,W,n,O. Throws Error where they are not legal, or M or V is above 18.
    /// Once it is clear that the bound is `enough` or more, some number from `enough` on.
    double operator()(const std::vector<int>& numbers, double enough = 2.0);

private:
    /// By bins of x.
    struct Range {
        double low = 0.0, high = 0.0;
    };
    using Ranges = std::vector<Range>;
    const Ranges& of_x(const std::vector<int>& numbers);
    const Ranges& of_y(const std::vector<int>& numbers);

    std::map<std::vector<int>, Ranges> x_, y_;
    std::map<int, std::vector<double>> fall_;  ///< exp(-2^x) at each x of V bits
};

}  // namespace glint
