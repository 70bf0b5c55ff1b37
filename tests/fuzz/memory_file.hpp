// A text as a file, for readers that take a path.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <string>

#include "check.hpp"

namespace glint::fuzz {

class MemoryFile {
public:
    explicit MemoryFile(const std::string& text) : file_(memfd_create("glint-fuzz", MFD_CLOEXEC)) {
        const auto size = static_cast<ssize_t>(text.size());
        require(file_ >= 0 && ::write(file_, text.data(), text.size()) == size, "there is memory for a file");
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    ~MemoryFile() { ::close(file_); }

    std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }

private:
    int file_;
};

}  // namespace glint::fuzz
