#include "junit.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace glint::testbench {
namespace {

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

}  // namespace

std::string to_junit(const std::string& suite, const std::vector<JUnitCase>& cases) {
    const auto failures = std::count_if(cases.begin(), cases.end(), [](const auto& c) { return !c.failure.empty(); });
    std::string out = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\">\n",
        escaped(suite), cases.size(), failures);
    for (const JUnitCase& c : cases) {
        out += fmt::format("  <testcase name=\"{}\" time=\"{:.3f}\"", escaped(c.name), c.seconds);
        out += c.failure.empty() ? "/>\n"
                                 : fmt::format(">\n    <failure message=\"failed\">{}</failure>\n  </testcase>\n",
                                               escaped(c.failure));
    }
    return out + "</testsuite>\n";
}

}  // namespace glint::testbench
