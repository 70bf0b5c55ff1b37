// A command line, run inside this program, and what it says.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace glint::fuzz {

struct Said {
    int status = 0;
    std::string out, err;
};

/// Runs `program` with a name and arguments. Its standard streams are texts.
Said run_command(const std::function<int(int, char**)>& program, std::string name,
                 const std::vector<std::string>& arguments, const std::string& in = {});

/// What a command line promises: status 0 or 1 and nothing said, or 2 and one line that begins with the program's name.
void check_promise(const Said& said, const std::string& name);

}  // namespace glint::fuzz
