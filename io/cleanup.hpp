// What a run that is interrupted takes with it: its temporary files and folders, and the programs that it has started.
#pragma once

#include <csignal>
#include <string>

namespace glint::io {

/// While it is there, a signal that ends this program first ends the other one, or removes the file or the folder.
class Cleanup {
public:
    enum class Kind { file, folder };

    /// Where 64 others are there, or the name has more than 1023 characters, nothing is done.
    Cleanup(Kind kind, const std::string& name);
    explicit Cleanup(int process);
    Cleanup(const Cleanup&) = delete;
    Cleanup& operator=(const Cleanup&) = delete;
    ~Cleanup();

private:
    int slot_ = -1;
};

/// While it is there, signals wait (in this thread): between what is made and its Cleanup none comes.
class SignalsWait {
public:
    SignalsWait();
    SignalsWait(const SignalsWait&) = delete;
    SignalsWait& operator=(const SignalsWait&) = delete;
    ~SignalsWait();
    const sigset_t& before() const { return before_; }  ///< those that waited already

private:
    sigset_t before_{};
};

/// Signals that end a program (Ctrl-C, `kill`, a closed terminal or pipe, the end of its processor time) clean up
/// first; one that is ignored stays ignored. A file that grows too large is an error of the write, not a signal.
void clean_up_when_interrupted();

}  // namespace glint::io
