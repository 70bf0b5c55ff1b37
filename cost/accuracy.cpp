#include "cost/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>

#include <fmt/format.h>

#include "glint/error.hpp"
#include "glint/lobes.hpp"
#include "glint/sweep.hpp"
#include "io/command.hpp"
#include "io/json_node.hpp"

namespace glint::cost {
namespace {

constexpr std::string_view accuracy_format = "glint-cost-accuracy-1";
constexpr int unit_bits = 8;  ///< of an error below the output's last place

/// A lobe and profile a line: a new one changes one line of the file.
std::string to_text(const std::vector<AccuracyRecord>& records) {
    std::string out =
        fmt::format("{{\"format\": \"{}\",\n \"unit\": \"2^-(O+{})\",\n \"points\": [", accuracy_format, unit_bits);
    for (const AccuracyRecord& r : records) {
        const nlohmann::ordered_json point{{"lobe", r.lobe},
                                           {"profile", r.profile},
                                           {"F", r.F},
                                           {"O", r.O},
                                           {"inputs", r.inputs},
                                           {"rounding_ulp", r.rounding},
                                           {"error_rounded_cosine", r.rounded_cosine},
                                           {"error_exact_cosine", r.exact_cosine}};
        out += fmt::format("{}\n{}", &r == records.data() ? "" : ",", point.dump());
    }
    return out + "\n]}\n";
}

/// In the order of the registry, then that of the shipped profiles, then by name.
bool before(const AccuracyRecord& a, const AccuracyRecord& b) {
    const auto place = [](const auto& all, const std::string& name) {
        return std::find_if(all.begin(), all.end(), [&](const auto& entry) { return entry.name == name; }) -
               all.begin();
    };
    const auto key = [&](const AccuracyRecord& r) {
        return std::tuple(place(lobes(), r.lobe), place(shipped_profiles(), r.profile), r.profile);
    };
    return key(a) < key(b);
}

}  // namespace

double AccuracyRecord::error(Range n, Cosine cosine) const {
    const std::vector<std::uint32_t>& errors = cosine == Cosine::rounded ? rounded_cosine : exact_cosine;
    std::uint32_t worst = 0;
    for (std::int64_t i = 0; i < n.size(); ++i) worst = std::max(worst, errors[static_cast<std::size_t>(n[i] - 1)]);
    return std::ldexp(worst, -O - unit_bits);
}

AccuracyRecord measure_accuracy(const GoldenModel& model, unsigned threads) {
    const Profile& profile = model.profile();
    AccuracyRecord out{std::string(model.lobe()), profile.argument(), profile.F, profile.O, 0, 0.0, {}, {}};
    const SweepResult swept = sweep(model, {1, max_n, 1}, {0, profile.one(), 1}, threads,
                                    io::progress_bar(fmt::format("{} {}", out.lobe, out.profile)));
    out.inputs = swept.total.inputs;
    out.rounding = swept.total.rounding.value;
    const auto units = [&](const Worst& worst) {
        return static_cast<std::uint32_t>(std::ceil(std::ldexp(worst.value, profile.O + unit_bits)));
    };
    for (const AccuracyRow& row : swept.rows) {
        out.rounded_cosine.push_back(units(row.accuracy.approximation));
        out.exact_cosine.push_back(units(row.accuracy.approximation_exact));
    }
    return out;
}

std::vector<AccuracyRecord> read_accuracy_file(const std::string& path) {
    const std::string name = fmt::format("accuracy file '{}'", path);
    const nlohmann::json json = io::read_json(path, name);
    const io::JsonNode top(json, name);
    if (top.text("format") != accuracy_format) top.fail("format", accuracy_format);
    std::vector<AccuracyRecord> out;
    for (const io::JsonNode& node : top.nodes("points")) {
        AccuracyRecord record;
        record.lobe = node.word("lobe");
        record.profile = node.text("profile");
        record.F = node.integer("F", 8, 30);
        record.O = node.integer("O", 4, 28);
        const std::uint64_t all = max_n * ((std::uint64_t{1} << record.F) + 1);
        record.inputs = node.count("inputs", all, all);
        record.rounding = node.number("rounding_ulp");
        record.rounded_cosine = node.counts("error_rounded_cosine", max_n);
        record.exact_cosine = node.counts("error_exact_cosine", max_n);
        out.push_back(std::move(record));
    }
    if (out.empty()) throw Error(name + " holds no points");
    return out;
}

int run_cost_accuracy(const std::string& lobes, const std::string& profiles, const std::string& json,
                      unsigned threads) {
    io::check_writable(json);
    const auto there = [&] {
        return !json.empty() && std::filesystem::is_regular_file(json) ? read_accuracy_file(json)
                                                                       : std::vector<AccuracyRecord>();
    };
    there();  // what can be refused is, before the work
    std::vector<AccuracyRecord> measured;
    bool failed = false;
    std::vector<std::vector<std::string>> rows{{"lobe", "profile", "rounding/ulp", "error", "n >= 8", "exact cos"}};
    for (const auto& model : io::models(lobes, profiles)) {
        AccuracyRecord record = measure_accuracy(*model, threads);
        const Range all{1, max_n, 1};
        rows.push_back({record.lobe, record.profile, fmt::format("{:.4f}", record.rounding),
                        fmt::format("{:.3g}", record.error(all, Cosine::rounded)),
                        fmt::format("{:.3g}", record.error({8, max_n, 1}, Cosine::rounded)),
                        fmt::format("{:.3g}", record.error(all, Cosine::exact))});
        failed = failed || (model->profile().shipped() && record.rounding >= find_lobe(model->lobe()).bound_ulp);
        measured.push_back(std::move(record));
    }
    if (!json.empty()) {
        const io::FolderLock lock(json);
        std::vector<AccuracyRecord> records = there();  // another run may have added some
        for (AccuracyRecord& record : measured) {
            std::erase_if(records, [&](const AccuracyRecord& old) {
                return old.lobe == record.lobe && old.profile == record.profile;
            });
            records.push_back(std::move(record));
        }
        std::sort(records.begin(), records.end(), before);
        io::write_file(json, to_text(records));
    }
    fmt::print("{}", io::table(rows));
    if (failed) fmt::print("FAILED: the rounding error of a shipped profile reaches the bound of its lobe\n");
    return failed ? io::check_failed : io::success;
}

}  // namespace glint::cost
