#include "cost/missing.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "cost/accuracy.hpp"
#include "cost/cpu_prices.hpp"

namespace glint::cost {

std::vector<std::string> not_measured(const std::string& folder) {
    const std::vector<AccuracyRecord> records = read_accuracy_file(folder + "/accuracy.json");
    const CpuPrices cpu = read_cpu_prices(folder + "/cpu.json");
    std::vector<std::string> out;
    for (const Lobe& lobe : lobes()) {
        for (const Profile& profile : shipped_profiles()) {
            if (std::none_of(records.begin(), records.end(), [&](const AccuracyRecord& record) {
                    return record.lobe == lobe.name && record.profile == profile.name;
                }))
                out.push_back(fmt::format("not measured: the errors of {} at {}", lobe.name, profile.name));
        }
        for (const char* type : {"double", "float", "fixed"}) {
            for (const char* form : {"scalar", "batch"}) {
                if (cpu.find(lobe.name, type, form) == nullptr)
                    out.push_back(fmt::format("not measured: {} on a processor, {}, {}", lobe.name, type, form));
            }
        }
    }
    return out;
}

}  // namespace glint::cost
