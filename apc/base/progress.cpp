#include "apc/base/progress.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>

#include "apc/base/stop.h"

namespace apc {
namespace {

std::atomic<int> interrupts{0};  // the one piece of process-wide state: a signal has nowhere else to write

extern "C" void on_interrupt(int) {
  if (++interrupts > 1) _exit(130);
}

std::string clock_text(double seconds) {
  char text[32];
  const int whole = static_cast<int>(seconds + 0.5);
  if (whole >= 3600)
    std::snprintf(text, sizeof text, "%d:%02d:%02d", whole / 3600, whole / 60 % 60, whole % 60);
  else
    std::snprintf(text, sizeof text, "%d:%02d", whole / 60, whole % 60);
  return text;
}

}  // namespace

Progress::Progress(std::string what, double total)
    : what_(std::move(what)),
      total_(total),
      start_(Clock::now()),
      last_(start_),
      terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (shown_ && terminal_) std::fputs("\r\033[K", stderr);
}

void Progress::show(double done, const std::string& remark) {
  const auto now = Clock::now();
  const double since = std::chrono::duration<double>(now - last_).count();
  if (since < (terminal_ ? 0.1 : 10.0)) return;
  last_ = now;
  shown_ = true;
  const double share = total_ > 0 ? done / total_ : 0.0;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const auto left = share > 1e-3 ? clock_text(elapsed * (1.0 - share) / share) + " left" : std::string("estimating");
  std::fprintf(stderr, "%s%s  %3.0f %%  %s elapsed, %s%s%s%s", terminal_ ? "\r\033[K" : "", what_.c_str(),
               100.0 * share, clock_text(elapsed).c_str(), left.c_str(), remark.empty() ? "" : "  ", remark.c_str(),
               terminal_ ? "" : "\n");
  std::fflush(stderr);
}

void request_stop() { interrupts = 1; }

void forget_stop() { interrupts = 0; }

bool stop_requested() { return interrupts > 0; }

void catch_interrupts() {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
}

}  // namespace apc
