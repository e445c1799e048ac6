/// Three kinds of failure, kept apart: the user's input (InputError, exit code 2), a solver that gave up (SolveError,
/// exit code 3), a broken promise of ours (expect, aborts). Physical outcomes are results and are never thrown.
///
/// Message grammar: where, what, (why), what to do:  `beds/jfk.json /profile/depth: 24 has no unit. Write "24 in".`
#pragma once

#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>

namespace apc {

/// The user's file or argument is wrong; the message says where and what to do.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A solver gave up. `time` is the simulated time in s; the message carries the state and what to try.
class SolveError : public std::runtime_error {
 public:
  explicit SolveError(const std::string& message, double at_time = 0.0) : std::runtime_error(message), time(at_time) {}
  double time;
};

/// The user asked to stop (^C); whatever was finished is kept.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

template <class... Parts>
std::string concat(const Parts&... parts) {
  std::ostringstream text;
  text.precision(10);
  (text << ... << parts);
  return text.str();
}

/// Throws InputError unless `ok`.
template <class... Parts>
void require(bool ok, const Parts&... parts) {
  if (!ok) throw InputError(concat(parts...));
}

/// A bug of ours: always checked, prints and aborts.
template <class... Parts>
void expect(bool ok, const Parts&... parts) {
  if (ok) return;
  std::fputs(concat("apc: broken promise: ", parts..., "\n").c_str(), stderr);
  std::abort();
}

}  // namespace apc
