/// Long work called from Python: it runs beside the interpreter, other Python threads go on, and ^C ends it with what
/// was finished kept.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <future>

#include "apc/base/require.h"
#include "apc/base/stop.h"

namespace apc::python {

/// The result of `work()`. Throws KeyboardInterrupt after ^C, and whatever `work` throws.
template <class Work>
auto call(const Work& work) {
  forget_stop();
  auto running = std::async(std::launch::async, work);
  bool asked = false;
  for (;;) {
    bool ready = false;
    {
      const pybind11::gil_scoped_release others_go_on;
      ready = running.wait_for(std::chrono::milliseconds(20)) == std::future_status::ready;
    }
    if (ready) break;
    if (!asked && PyErr_CheckSignals() != 0) {
      PyErr_Clear();
      request_stop();
      asked = true;
    }
  }
  try {
    auto result = running.get();
    if (!asked) return result;
  } catch (const Interrupted&) {
  }
  forget_stop();
  PyErr_SetNone(PyExc_KeyboardInterrupt);
  throw pybind11::error_already_set();
}

}  // namespace apc::python
