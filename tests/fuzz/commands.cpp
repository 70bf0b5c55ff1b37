#include "commands.hpp"

#include <cstdio>
#include <cstdlib>

#include "check.hpp"

namespace glint::fuzz {
namespace {

/// A standard stream that is a text while this is there. (The streams of glibc may be assigned.)
class Caught {
public:
    explicit Caught(FILE*& stream) : stream_(stream), was_(stream) { stream_ = open_memstream(&text_, &size_); }
    Caught(const Caught&) = delete;
    Caught& operator=(const Caught&) = delete;
    ~Caught() {
        if (stream_ != was_) text();
        std::free(text_);
    }
    /// Ends it.
    std::string text() {
        std::fclose(stream_);
        stream_ = was_;
        return {text_, size_};
    }

private:
    FILE*& stream_;
    FILE* const was_;
    char* text_ = nullptr;
    std::size_t size_ = 0;
};

}  // namespace

Said run_command(const std::function<int(int, char**)>& program, std::string name,
                 const std::vector<std::string>& arguments, const std::string& in) {
    std::vector<std::string> words{std::move(name)};
    for (const std::string& argument : arguments) words.emplace_back(argument.c_str());  // up to a NUL
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    std::string input = in;
    FILE* const was = stdin;
    stdin = fmemopen(input.data(), input.size(), "r");
    Said out;
    {
        Caught output(stdout), errors(stderr);
        out.status = program(static_cast<int>(words.size()), argv.data());
        out.err = errors.text();
        out.out = output.text();
    }
    std::fclose(stdin);
    stdin = was;
    return out;
}

void check_promise(const Said& said, const std::string& name) {
    if (said.status != 2) {
        require(said.status == 0 || said.status == 1, "the exit status is 0, 1 or 2");
        require(said.err.empty(), "nothing is said where nothing is refused");
        return;
    }
    require(said.err.starts_with(name + ": ") && said.err.ends_with('\n'), "a refusal begins with the program's name");
    check_line(std::string_view(said.err).substr(0, said.err.size() - 1));
}

}  // namespace glint::fuzz
