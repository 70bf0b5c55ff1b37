// `glint choose`: the best configuration under constraints, and the command that makes it.
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cost/prices.hpp"
#include "cost/table.hpp"
#include "glint/error.hpp"
#include "io/command.hpp"
#include "io/quantity.hpp"

namespace glint::cli {

using namespace cost;

namespace {

using Json = nlohmann::ordered_json;

struct ChooseOptions {
    std::string data = "cost/data";
    std::string device = "hx8k";
    std::string n = "all";
    std::string cosine = "rounded";
    std::string max_error, clock, latency_ns, throughput;
    int latency_clocks = 0, max_luts = -1, min_output_bits = 0;
    bool no_dsp = false, hls = false;
    std::string minimize = "luts";
    int runners_up = 5;
    std::string json;
};

/// A constraint as it was asked for.
struct Wish {
    std::string option;  ///< with what its value takes: "--max-luts {}"
    Constraint constraint;

    /// "--max-luts 1200"
    std::string with(const std::string& value) const { return fmt::format(fmt::runtime(option), value); }
    std::string name() const { return option.substr(0, option.find(' ')); }
    bool is_switch() const { return option.find('{') == std::string::npos; }
};

std::vector<Wish> wishes(const ChooseOptions& o) {
    std::vector<Wish> out;
    const auto wish = [&](const char* option, Metric metric, double bound) {
        out.push_back({option, {metric, bound}});
    };
    if (!o.max_error.empty()) {
        wish("--max-error {}", Metric::error, io::parse_quantity(o.max_error, "--max-error", {}));
    }
    if (!o.clock.empty()) {
        wish("--clock {}MHz", Metric::clock,
             io::parse_quantity(o.clock, "--clock", {{"MHz", 1e6}, {"GHz", 1e9}, {"kHz", 1e3}, {"Hz", 1.0}}));
    }
    if (!o.latency_ns.empty()) {
        wish("--latency-ns {}", Metric::latency,
             io::parse_quantity(o.latency_ns, "--latency-ns", {{"ns", 1.0}, {"us", 1e3}, {"ms", 1e6}}));
    }
    if (o.latency_clocks > 0) wish("--latency-clocks {}", Metric::latency_clocks, o.latency_clocks);
    if (!o.throughput.empty()) {
        wish("--throughput {}", Metric::throughput,
             io::parse_quantity(
                 o.throughput, "--throughput",
                 {{"/s", 1.0}, {"k", 1e3}, {"M", 1e6}, {"G", 1e9}, {"k/s", 1e3}, {"M/s", 1e6}, {"G/s", 1e9}}));
    }
    if (o.no_dsp) wish("--no-dsp", Metric::dsps, 0);
    if (o.max_luts >= 0) wish("--max-luts {}", Metric::luts, o.max_luts);
    if (o.min_output_bits > 0) wish("--min-output-bits {}", Metric::output_bits, o.min_output_bits);
    return out;
}

/// As an option takes it, without a power of ten: 0.0035, 50M.
std::string plain(double x, Metric metric) {
    if (x >= 1e6 && metric == Metric::throughput) return fmt::format("{:.9g}M", x / 1e6);
    std::string out = fmt::format("{:.12f}", x);
    out.erase(out.find_last_not_of('0') + 1);
    if (out.ends_with('.')) out.pop_back();
    return out;
}

/// Four significant digits, on the side where the constraint still holds for the number itself.
std::string loosened(double x, Metric metric) {
    const bool more_is_better = info(metric).more_is_better;
    if (x == std::round(x) && x < 1e6) return fmt::format("{:.0f}", x);
    const double place = std::pow(10.0, std::floor(std::log10(x)) - 3.0);
    // A hair more: in binary, a multiple of the place may come out on the wrong side of itself.
    const double rounded = more_is_better ? std::floor(x / place - 1e-6) : std::ceil(x / place + 1e-6);
    return plain(std::round(rounded * place * 1e12) / 1e12, metric);
}

/// What another one costs and gives against the best: what differs by at least a hundredth.
std::string against(const Configuration& best, const Configuration& other) {
    std::string out;
    const auto say = [&](const std::string& text) { out += (out.empty() ? "" : ", ") + text; };
    for (const Metric metric :
         {Metric::luts, Metric::dsps, Metric::brams, Metric::error, Metric::output_bits, Metric::latency, Metric::ns}) {
        const std::optional<double> a = value(best, metric);
        const std::optional<double> b = value(other, metric);
        if (!a || !b || std::abs(*a - *b) <= 0.01 * std::abs(*a)) continue;
        if (metric == Metric::luts && *a > 0.0) {
            say(fmt::format("{:+.0f} % LUTs", 100.0 * (*b / *a - 1.0)));
        } else if (metric == Metric::error) {
            say(fmt::format("error {} instead of {}", short_number(*b), short_number(*a)));
        } else if (metric == Metric::latency) {
            say(fmt::format("latency {} ns instead of {}", short_number(*b), short_number(*a)));
        } else if (metric == Metric::ns) {
            say(fmt::format("a result in {} ns instead of {}", short_number(*b), short_number(*a)));
        } else if (metric == Metric::output_bits) {
            say(fmt::format("{} output bits instead of {}", *b, *a));
        } else {  // counts
            say(fmt::format("{} {} instead of {}", *b, info(metric).unit, *a));
        }
    }
    return out.empty() ? "the same within a hundredth" : out;
}

bool in_registry(const Configuration& c) {
    const auto all = lobes();
    return std::any_of(all.begin(), all.end(), [&](const Lobe& lobe) { return lobe.name == c.lobe; });
}

bool is_same_unit(const Configuration& a, const Configuration& b) {
    return a.lobe == b.lobe && a.profile == b.profile && a.architecture == b.architecture;
}

struct Decision {
    std::vector<Configuration> all;  ///< of the device
    Choice choice;
};

Decision decide(const Prices& data, const Scope& scope, const std::string& device, const std::vector<Wish>& wanted,
                Metric best_in) {
    Decision out{join(data, scope, device), {}};
    std::erase_if(out.all, [](const Configuration& c) { return !in_registry(c); });  // a rival, that nothing emits
    // Where the blocks were of no use, the price without them is that of the same unit.
    const std::vector<Configuration> all = out.all;
    std::erase_if(out.all, [&](const Configuration& c) {
        return c.dsp && c.dsps == 0 && std::any_of(all.begin(), all.end(), [&](const Configuration& other) {
                   return !other.dsp && is_same_unit(c, other);
               });
    });
    std::vector<Constraint> constraints;
    for (const Wish& wish : wanted) constraints.push_back(wish.constraint);
    out.choice = choose(out.all, constraints, best_in);
    return out;
}

/// One step that opens a solution: an option as it would have to be, and the configuration that then does.
struct Step {
    std::string option;
    Configuration configuration;
};

std::vector<Step> steps(const Decision& none, const std::vector<Wish>& wanted, const Prices& data, const Scope& scope,
                        const std::string& device, Metric best_in) {
    std::vector<Step> out;
    for (const Relaxation& relaxation : none.choice.relaxations) {
        const Wish& wish = wanted[relaxation.constraint];
        const std::string bound = loosened(relaxation.bound, wish.constraint.metric);
        out.push_back(
            {wish.is_switch() ? "without " + wish.option : wish.with(bound), none.all[relaxation.configuration]});
    }
    for (const std::string& other : priced_devices(data)) {
        if (other == device) continue;
        const Decision elsewhere = decide(data, scope, other, wanted, best_in);
        if (elsewhere.choice.feasible.empty()) continue;
        out.push_back({"--device " + other, elsewhere.all[elsewhere.choice.feasible.front()]});
    }
    return out;
}

/// What a price on one device tells of another: all but what depends on the device, which is left at its least.
bool may_do(const Configuration& c, const std::vector<Wish>& wanted) {
    return std::all_of(wanted.begin(), wanted.end(), [&](const Wish& wish) {
        switch (wish.constraint.metric) {
            case Metric::clock:
            case Metric::latency:
            case Metric::throughput:
            case Metric::dsps:
                return true;
            default:
                return wish.constraint.holds(c);
        }
    });
}

/// Configurations that have prices on other devices but none on this, and may do there and be better than the best of
/// those that have: the fewest LUTs, which hardly depend on the device without DSP blocks, first.
std::vector<Configuration> unpriced(const Decision& decision, const Prices& data, const Scope& scope,
                                    const std::string& device, const std::vector<Wish>& wanted, Metric best_in) {
    const bool no_dsp = std::any_of(wanted.begin(), wanted.end(), [](const Wish& wish) {
        return wish.constraint.metric == Metric::dsps && wish.constraint.bound == 0.0;
    });
    std::vector<Configuration> out;
    for (Configuration& c : join(data, scope, "")) {
        const auto is_priced = [&](const Configuration& other) {
            return is_same_unit(c, other) && !(no_dsp && other.dsp && other.dsps > 0);
        };
        if (c.dsp || c.device == device || !in_registry(c) || !may_do(c, wanted)) continue;
        if (std::any_of(decision.all.begin(), decision.all.end(), is_priced)) continue;
        if (std::any_of(data.fpga.begin(), data.fpga.end(), [&](const Price& p) {  // one that does not fit
                return !p.fits && p.configuration.device == device && is_same_unit(c, p.configuration) &&
                       !p.configuration.dsp;
            })) {
            continue;
        }
        if (!decision.choice.feasible.empty() && !better(best_in, c, decision.all[decision.choice.feasible.front()])) {
            continue;
        }
        const auto known =
            std::find_if(out.begin(), out.end(), [&](const auto& other) { return is_same_unit(c, other); });
        if (known == out.end()) out.push_back(std::move(c));
    }
    std::stable_sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.luts < b.luts; });
    return out;
}

/// The commands that price them, at most five, for people.
void print_unpriced(const std::vector<Configuration>& some, const std::string& device, bool no_dsp, Json& json) {
    json["unpriced"] = Json::array();
    if (some.empty()) return;
    constexpr std::size_t most = 5;
    fmt::print("{} without a price on {} could be better, by their prices elsewhere{}; these price them:\n",
               some.size(), device, some.size() > most ? fmt::format(" (the first {})", most) : "");
    for (const Configuration& c : some) {
        const std::string line = fmt::format("glint cost --fpga --lobe {} --profile {} --architecture {} --device {}{}",
                                             c.lobe, c.profile, c.architecture, device, no_dsp ? " --dsp off" : "");
        if (json["unpriced"].size() < most) fmt::print("  {}\n", line);
        json["unpriced"].push_back({{"command", line}, {"luts", c.luts}, {"priced_on", c.device}, {"error", c.error}});
    }
}

/// A line where what is asked for needs clocks and the device's prices have none; else empty.
std::string without_clocks(const std::vector<Configuration>& all, const std::string& device,
                           const std::vector<Wish>& wanted, Metric best_in) {
    if (std::any_of(all.begin(), all.end(), [](const Configuration& c) { return c.clock_mhz.has_value(); })) return {};
    const auto needs = [](Metric metric) {
        return metric == Metric::clock || metric == Metric::latency || metric == Metric::ns ||
               metric == Metric::throughput;
    };
    std::string option = needs(best_in) ? fmt::format("--minimize {}", info(best_in).name) : "";
    for (const Wish& wish : wanted) {
        if (needs(wish.constraint.metric)) option = wish.name();
    }
    if (option.empty()) return {};
    return fmt::format("prices on {} are resources alone, without a clock: {} says nothing there\n", device, option);
}

int run_choose(ChooseOptions options, const std::string& command) {
    io::check_writable(options.json);
    const Metric best_in = find_metric(options.minimize).metric;
    const std::vector<Wish> wanted = wishes(options);
    Scope scope{parse_range(options.n, "--n", 1, max_n), parse_cosine(options.cosine), {}, options.hls};
    for (const Wish& wish : wanted) {
        if (wish.constraint.metric == Metric::clock) scope.asked_mhz = wish.constraint.bound;
    }
    const Prices data = read_cost_data(options.data);
    options.device = priced_device(data, options.device);
    const Decision decision = decide(data, scope, options.device, wanted, best_in);
    const Choice& choice = decision.choice;

    std::vector<std::string> asked;
    Json wanted_json = Json::array();
    for (const Wish& wish : wanted) {
        asked.push_back(wish.with(plain(wish.constraint.bound, wish.constraint.metric)));
        wanted_json.push_back(
            {{"option", wish.name()}, {"metric", info(wish.constraint.metric).name}, {"bound", wish.constraint.bound}});
    }
    Json json{{"tool", "glint choose"},
              {"version", GLINT_VERSION},
              {"command", command},
              {"n", {{"first", scope.n.first}, {"last", scope.n.last}, {"step", scope.n.step}}},
              {"cosine", options.cosine},
              {"device", options.device},
              {"minimize", options.minimize},
              {"wanted", wanted_json},
              {"configurations", decision.all.size()},
              {"feasible", choice.feasible.size()}};
    const auto finish = [&](int status) {
        if (!options.json.empty()) io::write_json(options.json, json);
        return status;
    };
    fmt::print("wanted: the best {} on {} for {}{}{}\n", options.minimize, options.device, to_text(scope),
               asked.empty() ? "" : "; ", fmt::join(asked, " "));

    const std::string clockless = without_clocks(decision.all, options.device, wanted, best_in);
    fmt::print("{}", clockless);
    std::vector<Configuration> others;  // whose prices are worth having
    if (clockless.empty()) others = unpriced(decision, data, scope, options.device, wanted, best_in);

    if (choice.feasible.empty()) {
        json["best"] = nullptr;
        json["relaxations"] = Json::array();
        fmt::print("none of the {} priced configurations will do", decision.all.size());
        std::vector<std::vector<std::string>> rows{{"one change is enough", "for", "with", "LUTs", "error"}};
        for (const Step& step : steps(decision, wanted, data, scope, options.device, best_in)) {
            const Configuration& c = step.configuration;
            rows.push_back({step.option, name_of(c), c.dsp ? "DSPs" : "no DSPs", fmt::format("{}", c.luts),
                            short_number(c.error)});
            json["relaxations"].push_back(
                {{"option", step.option}, {"configuration", configuration_json(step.configuration)}});
        }
        if (rows.size() == 1) {
            fmt::print(", and no change of one constraint or of the device is enough\n");
        } else {
            fmt::print(":\n{}", io::table(rows));
        }
        print_unpriced(others, options.device, options.no_dsp, json);
        return finish(io::check_failed);
    }

    std::vector<Configuration> shown;
    std::string notes;
    json["runners_up"] = Json::array();
    const auto most = static_cast<std::size_t>(options.runners_up) + 1;
    for (const std::size_t i : choice.worthwhile) {
        if (shown.size() == most) break;
        const Configuration& c = decision.all[i];
        Json row = configuration_json(c);
        row["emit"] = emit_line(c);
        if (shown.empty()) {
            json["best"] = row;
        } else {
            row["against_best"] = against(shown.front(), c);
            notes += fmt::format("  {}: {}\n", name_of(c), row["against_best"].get<std::string>());
            json["runners_up"].push_back(row);
        }
        shown.push_back(c);
    }
    fmt::print("{}", configurations_table(shown));
    if (!notes.empty()) fmt::print("against the first:\n{}", notes);
    fmt::print("{} of the {} priced configurations will do; {} of those are not beaten in everything by another\n",
               choice.feasible.size(), decision.all.size(), choice.worthwhile.size());
    print_unpriced(others, options.device, options.no_dsp, json);
    fmt::print("{}\n", emit_line(shown.front()));
    return finish(io::success);
}

}  // namespace

void add_choose(CLI::App& app, Chosen& chosen) {
    auto o = std::make_shared<ChooseOptions>();
    CLI::App* command = app.add_subcommand("choose", "The cheapest lobe, profile and architecture that will do");
    command->add_option("--max-error", o->max_error, "Largest absolute error against c^n");
    command->add_option("--n", o->n, "Exponents that the error is over: first:last or all")->capture_default_str();
    command->add_option("--cosine", o->cosine, "The cosine that it is at: rounded or exact")->capture_default_str();
    command->add_option("--device", o->device, "Device")->capture_default_str();
    command->add_option("--clock", o->clock, "Clock to be reached, and run at: 48MHz");
    command->add_option("--latency-ns", o->latency_ns, "Longest latency: 200ns");
    io::add_integer(*command, "--latency-clocks", o->latency_clocks, 1, 1'000'000, "Longest latency in clocks")
        ->default_str("");
    command->add_option("--throughput", o->throughput, "Results a second, at least: 40M");
    command->add_flag("--no-dsp", o->no_dsp, "Use no DSP blocks");
    command->add_flag("--hls", o->hls, "Also the HLS kernels, as Bambu made them (hls/README.md)");
    io::add_integer(*command, "--max-luts", o->max_luts, 0, 100'000'000, "Most LUTs")->default_str("");
    io::add_integer(*command, "--min-output-bits", o->min_output_bits, 4, 28, "Fewest fraction bits of the output")
        ->default_str("");
    command->add_option("--minimize", o->minimize, "luts, latency, ns, dsps, error or another metric")
        ->capture_default_str();
    io::add_integer(*command, "--runners-up", o->runners_up, 0, 100, "Runners-up to show");
    command->add_option("--data", o->data, "Folder of accuracy.json, fpga.json and hls.json")->capture_default_str();
    command->add_option("--json", o->json, "Write the same as JSON");
    command->footer("Example: glint choose --max-error 0.005 --n 8:1000 --device up5k --clock 16MHz");
    command->callback([=, &chosen] { chosen.run = [=, &chosen] { return run_choose(*o, chosen.command); }; });
}

}  // namespace glint::cli
