// `glint render` in a build without it, or without the libraries that it needs.
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "glint/error.hpp"

namespace glint::cli {

void add_render(CLI::App& app, Chosen& chosen) {
    CLI::App* command = app.add_subcommand("render", "A picture of a scene (not in this build)");
    command->allow_extras();
    command->footer("Example: glint render scenes/still_life.json -o still_life.png");
    command->callback(
        [&chosen] { chosen.run = []() -> int { throw Error("render is not in this build: " GLINT_RENDER_MISSING); }; });
}

}  // namespace glint::cli
