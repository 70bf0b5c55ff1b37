// A format, a lobe, a profile, a count and a seed: vectors, written and read back.
#include <sstream>

#include <fmt/format.h>

#include "check.hpp"
#include "glint/lobes.hpp"
#include "glint/vectors.hpp"
#include "io/command.hpp"
#include "targets.hpp"

namespace glint::fuzz {
namespace {

/// A line of a vector file, as docs/contract.md has it ("File formats"), read without the code that wrote it.
TestVector read_vector(std::string line, VectorFormat format) {
    long long n = 0, code = 0, y = 0, clamped = 0;
    if (format == VectorFormat::hex) {
        require(line.size() == 24, "a word of hex has 96 bits");
        const auto bits = [&](std::size_t first, std::size_t count) {
            return std::stoll(line.substr(first, count), nullptr, 16);
        };
        code = static_cast<std::int32_t>(static_cast<std::uint32_t>(bits(0, 8)));
        n = bits(8, 4);
        clamped = bits(12, 4);
        y = bits(16, 8);
    } else {
        if (format == VectorFormat::csv) std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream words(line);
        require(static_cast<bool>(words >> n >> code >> y >> clamped), "a line has four numbers");
    }
    require(clamped == 0 || clamped == 1, "clamped is a bit");
    return {static_cast<int>(n), static_cast<std::int32_t>(code), {static_cast<std::uint32_t>(y), clamped == 1}};
}

}  // namespace

static const Registration vectors("vectors", [](const std::string& text) {
    std::vector<std::string> words = split(text, ' ');
    if (text.size() > 300) return;
    words.resize(5);
    may_refuse([&] {
        const VectorFormat format = parse_vector_format(words[0]);
        const LobeChoice choice = parse_lobe(words[1]);
        const auto model = choice.lobe->golden(choice.profile(words[2]));
        const auto count = static_cast<std::size_t>(io::parse_integer(words[3], "--count", 1, 1000));
        const auto seed = static_cast<std::uint64_t>(io::parse_integer(words[4], "--seed", 0, io::largest_seed));
        const std::vector<TestVector> made = make_vectors(*model, count, seed);
        require(made.size() == count, "there are as many as were asked for");
        std::vector<std::string> lines = split(format_vectors(made, format), '\n');
        require(lines.back().empty(), "a file of vectors ends with a line feed");
        lines.pop_back();
        if (format == VectorFormat::csv) lines.erase(lines.begin());
        require(lines.size() == count, "a vector a line");
        for (std::size_t i = 0; i < count; ++i) {
            const TestVector read = read_vector(lines[i], format);
            require(read.n == made[i].n && read.cos_code == made[i].cos_code && read.expected == made[i].expected,
                    "a vector, read, is itself");
            require(model->eval_port(read.n, read.cos_code) == read.expected, "its result is the model's");
        }
    });
});

}  // namespace glint::fuzz
