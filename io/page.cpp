#include "io/page.hpp"

#include <optional>

#include <fmt/format.h>

#include "glint/error.hpp"
#include "io/command.hpp"
#include "io/process.hpp"

namespace glint::io {
namespace fs = std::filesystem;
namespace {

fs::path find_script(const std::string& script) {
    const fs::path program = fs::read_symlink("/proc/self/exe");
    const fs::path places[] = {program.parent_path().parent_path() / "share/glint/page", GLINT_PAGE_FOLDER};
    for (const fs::path& place : places) {
        if (fs::is_regular_file(place / script)) return place / script;
    }
    throw Error(fmt::format("script '{}' is not there: neither in {} nor in {}", script, places[0].string(),
                            places[1].string()));
}

}  // namespace

void run_page_script(const std::string& script, const std::string& json, const fs::path& output) {
    const fs::path path = find_script(script);
    std::optional<fs::path> python = find_on_path("python3");
    if (!python && fs::exists("/usr/bin/python3")) python = "/usr/bin/python3";
    if (!python) throw Error("python3 is not on the PATH: install the package `python3`");
    const TemporaryFolder folder;
    const fs::path input = folder.path() / "input.json", log = folder.path() / "log";
    write_file(input, json);
    // -B: nothing is written beside the script.
    const int status =
        run_program(*python, {"-B", path.string(), input.string(), "-o", output.string()}, fs::current_path(), log);
    const std::string said = read_file(log);
    if (status == 2) throw Error(last_line(said));
    if (status != 0)
        throw Error(fmt::format("{} failed with exit status {}: {}", path.string(), status, last_line(said)));
    fmt::print("{}", said);
}

}  // namespace glint::io
