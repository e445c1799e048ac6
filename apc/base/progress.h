/// Progress of long work on stderr: one rewritten line with time left on a terminal, a plain line every ten seconds
/// elsewhere; and the flag that ^C sets.
#pragma once

#include <chrono>
#include <string>

namespace apc {

class Progress {
 public:
  /// `total` in any unit of work; `what` names the work ("SPH run H44.5 70 kt").
  explicit Progress(std::string what, double total = 1.0);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// Reports `done` of the total, with an optional remark behind it. Cheap: prints at most ten times a second.
  void show(double done, const std::string& remark = "");

 private:
  using Clock = std::chrono::steady_clock;
  std::string what_;
  double total_;
  Clock::time_point start_, last_;
  bool terminal_, shown_ = false;
};

/// True once the user has pressed ^C (or SIGTERM came). Long loops ask and throw Interrupted.
bool stop_requested();
/// Installs the handler; a second ^C ends the program at once.
void catch_interrupts();

}  // namespace apc
