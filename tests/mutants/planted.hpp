#pragma once
// Included by each source in which cpp_faults.py planted faults: GLINT_PLANTED chooses one by its number. At the end
// the numbers of those that were passed go into a file of the folder GLINT_PLANTED_LOG.

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace glint_planted {

template <class T>
struct Faults {  // a template, for C++14 has no inline variables
    static int chosen;
    static bool reached[1 << 14];
    static Faults log;
    ~Faults() {
        const char* folder = std::getenv("GLINT_PLANTED_LOG");
        if (folder == nullptr) return;
        std::FILE* file = std::fopen((std::string(folder) + "/" + std::to_string(getpid())).c_str(), "w");
        if (file == nullptr) return;
        for (int number = 0; number < 1 << 14; ++number)
            if (reached[number]) std::fprintf(file, "%d\n", number);
        std::fclose(file);
    }
};
template <class T>
int Faults<T>::chosen = std::getenv("GLINT_PLANTED") == nullptr ? 0 : std::atoi(std::getenv("GLINT_PLANTED"));
template <class T>
bool Faults<T>::reached[1 << 14];
template <class T>
Faults<T> Faults<T>::log;

inline bool on_at_run_time(int number) {
    bool& reached = Faults<void>::reached[number];
    if (!reached) reached = static_cast<bool>(&Faults<void>::log);
    return Faults<void>::chosen == number;
}

/// Is it this fault that was chosen? Never in what the compiler computes.
constexpr bool on(int number) { return !__builtin_is_constant_evaluated() && on_at_run_time(number); }

}  // namespace glint_planted
