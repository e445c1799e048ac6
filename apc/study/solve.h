/// The one call a study makes again and again. Studies, designs and reliability take it as an argument, so that tests
/// can put a closed form in its place; the program passes `simulation::simulate`, or `simulation::Together` where many
/// threads ask at the same time.
#pragma once

#include <functional>

#include "apc/simulation/simulate.h"

namespace apc::study {

using Solve =
    std::function<simulation::Result(const simulation::Model&, const simulation::Overrun&, const simulation::Options&)>;

}  // namespace apc::study
