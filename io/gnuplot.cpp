#include "io/gnuplot.hpp"

#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "glint/error.hpp"
#include "io/command.hpp"
#include "io/process.hpp"

namespace glint::io {
namespace fs = std::filesystem;

Pictures run_gnuplot(const std::string& script, const std::vector<std::string>& pictures) {
    const std::optional<fs::path> gnuplot = find_on_path("gnuplot");
    if (!gnuplot) {
        throw Error("gnuplot is not on the PATH: install the package `gnuplot-nox` (Debian, Ubuntu) or `gnuplot`");
    }
    const TemporaryFolder folder;
    const fs::path log = folder.path() / "log";
    write_file(folder.path() / "report.gp", script);
    // -d: a user's own settings would change the pictures.
    const int status = run_program(*gnuplot, {"-d", "report.gp"}, folder.path(), log);
    std::string said = last_line(read_file(log));
    if (!said.empty()) said = ": " + said;
    if (status != 0) throw Error(fmt::format("gnuplot failed with exit status {}{}", status, said));
    Pictures out;
    for (const std::string& name : pictures) {
        const fs::path picture = folder.path() / name;
        std::string bytes = fs::exists(picture) ? read_file(picture) : "";
        if (bytes.empty()) throw Error(fmt::format("gnuplot ended without writing '{}'{}", name, said));
        out.emplace(name, std::move(bytes));
    }
    return out;
}

}  // namespace glint::io
