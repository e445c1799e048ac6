/// A few threads that stay alive between the many short loops of a step. Work is cut into fixed pieces; which thread
/// takes a piece does not matter because no piece writes what another reads: same bits for any number of threads.
///
/// Every thread begins with its own share of the pieces, the same part of the whole in every loop, so that what it
/// wrote in one loop is still in its cache in the next; then it helps the others.
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
  /// Pieces [next, end) that nobody has taken; on a cache line of its own, like what all threads look at below.
  struct alignas(64) Share {
    std::atomic<int> next{0};
    int end = 0;
  };

  void live(int self);
  void drain(int self);

  std::vector<Share> shares_;  ///< one per thread, the caller's first
  const std::function<void(int, int)>* work_ = nullptr;
  int count_ = 0, piece_ = 1;
  std::vector<double> parts_;
  alignas(64) std::atomic<int> gate_;  ///< workers inside, and a flag while it is closed
  alignas(64) std::atomic<unsigned> round_{0};
  std::atomic<bool> leave_{false};
  std::vector<std::jthread> workers_;  // last: they end before what they use
};

}  // namespace apc::sph
