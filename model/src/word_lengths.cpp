#include "glint/word_lengths.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "glint/error.hpp"
#include "glint/sweep.hpp"

namespace glint {
namespace {

Profile custom_profile(const std::vector<int>& numbers) {
    return parse_profile(fmt::format("{}", fmt::join(numbers, ",")));
}

/// Which numbers of a custom profile are word lengths to be searched.
std::vector<bool> word_lengths(const Lobe& lobe) {
    std::vector<bool> out;
    bool begins = true;
    for (const char c : lobe.custom) {
        if (begins) out.push_back(std::isupper(static_cast<unsigned char>(c)) != 0);
        begins = c == ',';
    }
    out.front() = out.back() = false;  // F and O are given
    return out;
}

/// Whether the rounding error is below the lobe's bound at every n and the codes.
bool faithful(const GoldenModel& model, Range codes, unsigned threads) {
    return sweep(model, {1, max_n, 1}, codes, threads).total.rounding.value < find_lobe(model.lobe()).bound_ulp;
}

/// The same at some of the codes, those near 1 among them: it tells most of the formats that break the promise.
bool faithful_sample(const GoldenModel& model, unsigned threads) {
    const std::int64_t one = model.profile().one();
    return faithful(model, {std::max<std::int64_t>(0, one - 2047), one, 1}, threads) &&
           faithful(model, {0, one, 31}, threads);
}

}  // namespace

std::vector<std::vector<int>> minimal_points(const std::vector<int>& low, const std::vector<int>& high,
                                             const std::function<bool(const std::vector<int>&)>& good) {
    std::vector<std::vector<int>> out;
    if (low.empty()) {
        if (good({})) out.emplace_back();
        return out;
    }
    // For every setting of the coordinates but the last, in an order that comes to no setting before those below it:
    // the least last coordinate that is good; one more than the box has where none is.
    const std::vector<int> head_low(low.begin(), low.end() - 1);
    const std::vector<int> head_high(high.begin(), high.end() - 1);
    std::map<std::vector<int>, int> least;
    for (std::vector<int> head = head_low;;) {
        int bound = high.back() + 1;  // good from here on, since it is so for a setting below
        for (std::size_t i = 0; i < head.size(); ++i) {
            if (head[i] == head_low[i]) continue;
            std::vector<int> below = head;
            --below[i];
            bound = std::min(bound, least.at(below));
        }
        const auto is_good = [&](int last) {
            std::vector<int> point = head;
            point.push_back(last);
            return good(point);
        };
        int found = bound;
        if (bound > low.back() && is_good(bound - 1)) {
            int bad = low.back() - 1;
            for (found = bound - 1; found - bad > 1;) {
                const int middle = bad + (found - bad) / 2;
                (is_good(middle) ? found : bad) = middle;
            }
            out.push_back(head);
            out.back().push_back(found);
        }
        least[head] = found;

        std::size_t i = head.size();
        while (i > 0 && head[i - 1] == head_high[i - 1]) {
            head[i - 1] = head_low[i - 1];
            --i;
        }
        if (i == 0) return out;
        ++head[i - 1];
    }
}

GuardSearch find_guard_bits(const Lobe& lobe, const GuardBits& bits, unsigned threads) {
    std::vector<int> numbers = lobe.numbers(bits.F, bits.O);
    custom_profile(numbers);  // refuses F and O
    const std::vector<bool> varies = word_lengths(lobe);
    std::vector<std::size_t> places;
    std::vector<int> low;
    std::vector<int> high;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (!varies[i]) continue;
        places.push_back(i);
        low.push_back(std::max(0, numbers[i] - bits.fewer));
        high.push_back(numbers[i] + bits.more);
    }
    const auto profile_of = [&](const std::vector<int>& point) {
        for (std::size_t k = 0; k < places.size(); ++k) numbers[places[k]] = point[k];
        return custom_profile(numbers);
    };

    GuardSearch out;
    std::map<std::vector<int>, bool> sampled;  // by the varied word lengths: good, as far as is known
    const auto good = [&](const std::vector<int>& point) {
        const auto known = sampled.find(point);
        if (known != sampled.end()) return known->second;
        std::unique_ptr<GoldenModel> model;
        try {
            model = lobe.golden(profile_of(point));
        } catch (const Error&) {
            return sampled[point] = false;  // not legal for this lobe
        }
        ++out.tried;
        return sampled[point] = faithful_sample(*model, threads);
    };
    const auto total = [](const std::vector<int>& point) { return std::accumulate(point.begin(), point.end(), 0); };
    std::set<std::vector<int>> measured;
    for (bool all_good = false; !all_good;) {
        std::vector<std::vector<int>> points = minimal_points(low, high, good);
        std::stable_sort(points.begin(), points.end(),
                         [&](const auto& a, const auto& b) { return total(a) < total(b); });
        if (points.size() > static_cast<std::size_t>(bits.most)) points.resize(static_cast<std::size_t>(bits.most));
        all_good = true;
        out.least.clear();
        for (const std::vector<int>& point : points) {
            const Profile profile = profile_of(point);
            if (measured.insert(point).second) {
                sampled[point] = faithful(*lobe.golden(profile), {0, profile.one(), 1}, threads);
            }
            all_good = all_good && sampled[point];
            out.least.push_back(profile);
        }
    }
    out.measured = static_cast<int>(measured.size());
    return out;
}

}  // namespace glint
