// Independent tasks on all cores.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace glint {

/// Told from time to time how much of a work is done, in [0, 1]. Called from any thread, one at a time.
using Progress = std::function<void(double)>;

/// Threads to use when the caller asks for 0: as many as the machine has.
inline unsigned thread_count(unsigned asked) {
    if (asked != 0) return asked;
    const unsigned cores = std::thread::hardware_concurrency();
    return cores == 0 ? 1 : cores;
}

/// Runs task(0) .. task(count - 1), each once, on `threads` threads (0: one a core). Every thread calls make_worker()
/// for a callable of its own, so that what is costly to build (a simulation) is built once a thread. The first
/// exception stops the rest and is thrown here.
void parallel_tasks(std::size_t count, unsigned threads, const Progress& progress, auto make_worker) {
    std::atomic<std::size_t> next{0};
    std::size_t done = 0;
    std::mutex mutex;
    std::exception_ptr failure;
    const auto run = [&] {
        try {
            auto worker = make_worker();
            for (std::size_t task = next++; task < count; task = next++) {
                worker(task);
                const std::lock_guard lock(mutex);
                ++done;
                if (progress) progress(static_cast<double>(done) / static_cast<double>(count));
            }
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!failure) failure = std::current_exception();
            next = count;
        }
    };
    std::vector<std::thread> pool;
    for (unsigned i = 1; i < thread_count(threads); ++i) pool.emplace_back(run);
    run();
    for (std::thread& thread : pool) thread.join();
    if (failure) std::rethrow_exception(failure);
}

}  // namespace glint
