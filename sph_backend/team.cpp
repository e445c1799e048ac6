#include "sph_backend/team.h"

#include <algorithm>

namespace apc::sph {
namespace {

/// Looks again and again for some ten microseconds, the length of what one thread does alone within a step.
template <class Done>
bool soon(const Done& done) {
  for (int looks = 0; looks < 1000; ++looks) {
    if (done()) return true;
    __builtin_ia32_pause();
  }
  return false;
}

}  // namespace

Team::Team(unsigned threads) {
  for (unsigned t = 1; t < threads; ++t)
    workers_.emplace_back([this] {
      unsigned seen = 0;
      while (true) {
        // Whoever has looked long enough sleeps: others may need the processor.
        if (!soon([&] { return round_.load(std::memory_order_acquire) != seen; }))
          round_.wait(seen, std::memory_order_acquire);
        if (leave_.load(std::memory_order_relaxed)) return;
        seen = round_.load(std::memory_order_acquire);
        drain();
        busy_.fetch_sub(1, std::memory_order_release);
      }
    });
}

Team::~Team() {
  leave_ = true;
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
}

void Team::drain() {
  for (int first = next_.fetch_add(piece_); first < count_; first = next_.fetch_add(piece_))
    (*work_)(first, std::min(first + piece_, count_));
}

void Team::run(int count, int piece, const std::function<void(int, int)>& work) {
  if (workers_.empty() || count <= piece) {
    if (count > 0) work(0, count);
    return;
  }
  work_ = &work, count_ = count, piece_ = piece;
  next_.store(0, std::memory_order_relaxed);
  busy_.store(static_cast<int>(workers_.size()), std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  drain();
  while (!soon([&] { return busy_.load(std::memory_order_acquire) == 0; })) std::this_thread::yield();
}

double Team::sum(int count, int piece, const std::function<double(int, int)>& work) {
  parts_.assign((count + piece - 1) / piece, 0.0);
  run(static_cast<int>(parts_.size()), 1, [&](int first, int last) {
    for (int k = first; k < last; ++k) parts_[k] = work(k * piece, std::min((k + 1) * piece, count));
  });
  double total = 0.0;
  for (const double part : parts_) total += part;
  return total;
}

}  // namespace apc::sph
