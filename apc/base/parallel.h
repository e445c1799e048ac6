/// Independent work on several threads, results in the order of the input: the same answer for any number of threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace apc {

inline unsigned hardware_threads() { return std::max(1u, std::thread::hardware_concurrency()); }

/// Calls `work(i)` for i in [0, count) on `threads` threads (0 = all). The first exception is rethrown after all stop.
template <class Work>
void parallel_for(std::size_t count, unsigned threads, const Work& work) {
  if (threads == 0) threads = hardware_threads();
  threads = static_cast<unsigned>(std::min<std::size_t>(threads, count));
  if (threads <= 1) {
    for (std::size_t i = 0; i < count; ++i) work(i);
    return;
  }
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex guard;
  const auto drain = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(guard);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::thread> crew;
  for (unsigned t = 1; t < threads; ++t) crew.emplace_back(drain);
  drain();
  for (auto& thread : crew) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace apc
