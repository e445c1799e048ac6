/// The parts of the module `_apc`; each adds its calls. Results are dicts of numbers, texts and NumPy arrays in SI.
#pragma once

#include <pybind11/pybind11.h>

#include "apc/simulation/result.h"

namespace apc::python {

void bind_bed(pybind11::module_&);
void bind_simulate(pybind11::module_&);
void bind_study(pybind11::module_&);
void bind_design(pybind11::module_&);
void bind_reliability(pybind11::module_&);
void bind_report(pybind11::module_&);

/// One overrun; its history is left out when it is empty.
pybind11::dict result_dict(const simulation::Result&);

}  // namespace apc::python
