#include "io/cleanup.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace glint::io {
namespace {

enum class Held { nothing, not_yet, file, folder, program };

struct Slot {
    std::atomic<Held> held{Held::nothing};
    std::atomic<int> process{0};
    std::array<char, 1024> name{};
};

// The handler may run at any moment, in any thread: it reads these and calls the kernel, and does nothing else.
std::array<Slot, 64> slots;

/// What std::filesystem::remove_all does is not for signal handlers.
void remove_folder(int parent, const char* name, int depth) {
    const int folder = openat(parent, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (folder < 0) return;
    alignas(dirent64) std::array<char, 4096> block;
    for (long got = 0; (got = syscall(SYS_getdents64, folder, block.data(), block.size())) > 0;) {
        for (long at = 0; at < got;) {
            const auto* entry = reinterpret_cast<const dirent64*>(block.data() + at);
            at += entry->d_reclen;
            const char* const inner = static_cast<const char*>(entry->d_name);
            if (std::strcmp(inner, ".") == 0 || std::strcmp(inner, "..") == 0) continue;
            if (unlinkat(folder, inner, 0) != 0 && depth > 0) remove_folder(folder, inner, depth - 1);
        }
    }
    close(folder);
    unlinkat(parent, name, AT_REMOVEDIR);
}

/// Asks it to end, and makes it end after two seconds.
void end_program(int process) {
    kill(process, SIGTERM);
    for (int i = 0; i < 200; ++i) {
        if (waitpid(process, nullptr, WNOHANG) != 0) return;
        poll(nullptr, 0, 10);
    }
    kill(process, SIGKILL);
    waitpid(process, nullptr, 0);
}

void clean_up(int signal) {
    const int error = errno;
    for (const Slot& slot : slots) {  // first: they may write to the folders
        if (slot.held == Held::program) end_program(slot.process);
    }
    for (const Slot& slot : slots) {
        if (slot.held == Held::file) unlink(slot.name.data());
        if (slot.held == Held::folder) remove_folder(AT_FDCWD, slot.name.data(), 4);
    }
    errno = error;
    raise(signal);  // the handler is gone (SA_RESETHAND): the program ends as one without a handler does
}

Slot* take_slot() {
    for (Slot& slot : slots) {
        Held expected = Held::nothing;
        if (slot.held.compare_exchange_strong(expected, Held::not_yet)) return &slot;
    }
    return nullptr;
}

}  // namespace

Cleanup::Cleanup(Kind kind, const std::string& name) {
    Slot* const slot = name.size() < slots[0].name.size() ? take_slot() : nullptr;
    if (slot == nullptr) return;
    std::memcpy(slot->name.data(), name.c_str(), name.size() + 1);
    slot->held = kind == Kind::file ? Held::file : Held::folder;
    slot_ = static_cast<int>(slot - slots.data());
}

Cleanup::Cleanup(int process) {
    Slot* const slot = take_slot();
    if (slot == nullptr) return;
    slot->process = process;
    slot->held = Held::program;
    slot_ = static_cast<int>(slot - slots.data());
}

Cleanup::~Cleanup() {
    if (slot_ >= 0) slots[static_cast<std::size_t>(slot_)].held = Held::nothing;
}

SignalsWait::SignalsWait() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before_);
}

SignalsWait::~SignalsWait() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

void clean_up_when_interrupted() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXCPU}) {
        struct sigaction now {};
        if (sigaction(signal, nullptr, &now) != 0 || now.sa_handler != SIG_DFL) continue;
        struct sigaction ours {};
        ours.sa_handler = clean_up;
        ours.sa_flags = static_cast<int>(SA_RESETHAND);
        sigfillset(&ours.sa_mask);
        sigaction(signal, &ours, nullptr);
    }
    std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace glint::io
