#include "glint/fit.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "glint/error.hpp"
#include "io/command.hpp"

namespace glint::cli {
namespace {

struct FitOptions {
    std::string variable = "schlick";
    int degree = 3;
    std::string method = "least-squares";
    std::string n = "1:1000:1";
    std::string theta = "0:1.57:0.001";
    bool zero_at_0 = false;
    bool one_at_1 = false;
    std::string json;
};

int run_fit(const FitOptions& options, const std::string& command) {
    FitRequest request;
    request.variable = parse_variable(options.variable);
    request.degree = options.degree;
    request.method = parse_fit_method(options.method);
    request.n = parse_range(options.n, "--n", 1, max_n);
    request.theta = parse_real_range(options.theta, "--theta", 0.0, 1.5707963267948966);
    request.zero_at_0 = options.zero_at_0;
    request.one_at_1 = options.one_at_1;
    const Fit result = fit(request);

    std::vector<std::vector<std::string>> rows{{"power", "coefficient"}};
    std::string list;
    for (std::size_t k = 0; k < result.coefficients.size(); ++k) {
        rows.push_back({std::to_string(k), fmt::format("{:.9g}", result.coefficients[k])});
        list += fmt::format(":{:.9g}", result.coefficients[k]);
    }
    if (!options.json.empty()) {
        nlohmann::ordered_json out;
        out["tool"] = "glint fit";
        out["command"] = command;
        out["variable"] = name(request.variable);
        out["method"] = name(request.method);
        out["coefficients"] = result.coefficients;
        out["rows"] = result.rows;
        out["rms"] = result.rms;
        out["largest"] = {{"error", result.largest}, {"n", result.largest_n}, {"theta", result.largest_theta}};
        io::write_json(options.json, out);
    }
    fmt::print("{} by {}, degree {}, {} rows\n{}", name(request.variable), name(request.method), request.degree,
               result.rows, io::table(rows));
    fmt::print(
        "error of the polynomial, not cut at 0, over the rows: RMS {:.6f}, largest {:.6f} at n={} theta={:.4f}\n",
        result.rms, result.largest, result.largest_n, result.largest_theta);
    if (request.degree >= 2 && request.degree <= 6) {
        fmt::print("glint emit --lobe polynomial:{}{} --profile p12 -o out\n", name(request.variable), list);
    }
    return io::success;
}

}  // namespace

void add_fit(CLI::App& app, Chosen& chosen) {
    auto options = std::make_shared<FitOptions>();
    CLI::App* command = app.add_subcommand("fit", "Fit a polynomial in a rational variable to Blinn-Phong");
    command->add_option("--variable", options->variable, "schlick: c/(n-nc+c); symmetric: (1+c)/((1+c)+2n(1-c))")
        ->capture_default_str();
    io::add_integer(*command, "--degree", options->degree, 1, 8, "Degree of the polynomial");
    command->add_option("--method", options->method, "least-squares (normal equations), qr or minimax")
        ->capture_default_str();
    command->add_option("--n", options->n, "Exponents: n, first:last or first:last:step")->capture_default_str();
    command->add_option("--theta", options->theta, "Angles in radians: theta or first:last:step")
        ->capture_default_str();
    command->add_flag("--zero-at-0", options->zero_at_0, "The polynomial is 0 at 0");
    command->add_flag("--one-at-1", options->one_at_1, "The polynomial is 1 at 1");
    command->add_option("--json", options->json, "Write the same as JSON");
    command->footer("Example: glint fit --variable symmetric --degree 4 --method minimax --n 8:1000 --one-at-1");
    command->callback([=, &chosen] { chosen.run = [=, &chosen] { return run_fit(*options, chosen.command); }; });
}

}  // namespace glint::cli
