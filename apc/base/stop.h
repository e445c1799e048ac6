/// Stopping long work from inside the process, where no signal comes: a binding that watches its own ^C.
#pragma once

namespace apc {

/// From now on `stop_requested()` (progress.h) is true.
void request_stop();
/// And false again, for the next piece of work.
void forget_stop();

}  // namespace apc
