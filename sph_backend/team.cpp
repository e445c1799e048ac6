#include "sph_backend/team.h"

#include <algorithm>
#include <chrono>

namespace apc::sph {
namespace {

/// Looks again and again for a tenth of a millisecond, longer than what one thread does alone within a step.
template <class Done>
bool soon(const Done& done) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  do {
    for (int looks = 0; looks < 50; ++looks) {
      if (done()) return true;
      __builtin_ia32_pause();
    }
  } while (Clock::now() - begin < std::chrono::microseconds(100));
  return false;
}

constexpr int closed = 1 << 30;

}  // namespace

Team::Team(unsigned threads) : shares_(threads > 0 ? threads : 1), gate_(closed) {
  for (unsigned t = 1; t < threads; ++t) workers_.emplace_back([this, t] { live(static_cast<int>(t)); });
}

Team::~Team() {
  leave_ = true;
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
}

void Team::live(int self) {
  unsigned seen = 0;
  while (true) {
    // Whoever has looked long enough sleeps: others may need the processor.
    if (!soon([&] { return round_.load(std::memory_order_acquire) != seen; }))
      round_.wait(seen, std::memory_order_acquire);
    if (leave_.load(std::memory_order_relaxed)) return;
    seen = round_.load(std::memory_order_acquire);
    if (!(gate_.fetch_add(1, std::memory_order_acq_rel) & closed)) drain(self);
    gate_.fetch_sub(1, std::memory_order_release);
  }
}

void Team::drain(int self) {
  const int threads = static_cast<int>(shares_.size());
  for (int k = 0; k < threads; ++k) {
    Share& share = shares_[(self + k) % threads];
    for (int at = share.next.fetch_add(1); at < share.end; at = share.next.fetch_add(1))
      (*work_)(at * piece_, std::min((at + 1) * piece_, count_));
  }
}

void Team::run(int count, int piece, const std::function<void(int, int)>& work) {
  if (workers_.empty() || count <= piece) {
    if (count > 0) work(0, count);
    return;
  }
  work_ = &work, count_ = count, piece_ = piece;
  const long pieces = (count + piece - 1) / piece, threads = static_cast<long>(shares_.size());
  for (long t = 0; t < threads; ++t) {
    shares_[t].next.store(static_cast<int>(pieces * t / threads), std::memory_order_relaxed);
    shares_[t].end = static_cast<int>(pieces * (t + 1) / threads);
  }
  gate_.fetch_and(~closed, std::memory_order_release);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  drain(0);
  // Only those who came in time are waited for: a thread that the processor has no room for must not hold up the rest.
  gate_.fetch_or(closed, std::memory_order_acq_rel);
  while (!soon([&] { return gate_.load(std::memory_order_acquire) == closed; })) std::this_thread::yield();
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
