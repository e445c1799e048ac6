/// A few threads that stay alive between the many short loops of a step. Work is cut into fixed pieces; which thread
/// takes a piece does not matter because no piece writes what another reads: same bits for any number of threads.
#pragma once

#include <atomic>
#include <functional>
#include <thread>
#include <vector>

namespace apc::sph {

class Team {
 public:
  explicit Team(unsigned threads);
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  /// Calls `work(first, last)` for pieces of at most `piece` that cover [0, count); returns when all are done.
  void run(int count, int piece, const std::function<void(int, int)>& work);
  /// Sum of `work(first, last)` over the same pieces, added in their order.
  double sum(int count, int piece, const std::function<double(int, int)>& work);

 private:
  void drain();

  std::vector<std::jthread> workers_;
  const std::function<void(int, int)>* work_ = nullptr;
  int count_ = 0, piece_ = 1;
  std::vector<double> parts_;
  // Each on a cache line of its own: all are written while all threads look at them.
  alignas(64) std::atomic<int> next_{0};
  alignas(64) std::atomic<int> busy_{0};
  alignas(64) std::atomic<unsigned> round_{0};
  std::atomic<bool> leave_{false};
};

}  // namespace apc::sph
