// A file of results, as `glint report` reads it, and behind a separator one of proofs.
#include "check.hpp"
#include "cli/report/inputs.hpp"
#include "io/files.hpp"
#include "memory_file.hpp"
#include "targets.hpp"

namespace glint::fuzz {

static const Registration results("results", [](const std::string& text) {
    const std::vector<std::string> parts = split(text, separator);
    may_refuse([&] {
        const nlohmann::json results = cli::read_results(MemoryFile(parts[0]).path());
        const nlohmann::json proofs =
            parts.size() > 1 ? cli::read_proofs(MemoryFile(parts[1]).path()) : nlohmann::json();
        require(io::json_text(cli::problems({results}, proofs)).ends_with("]\n"), "the report says what is wrong");
    });
});

}  // namespace glint::fuzz
