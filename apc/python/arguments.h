/// What Python hands over: quantities as text with a unit ("70 kt") or as a number in SI, and names or paths.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "apc/base/quantity.h"
#include "apc/bed/bed.h"
#include "apc/cli/inputs.h"

namespace apc::python {

namespace py = pybind11;

/// "70 kt" or 36.0. InputError "speed: …" for anything else.
double quantity(const py::handle&, const Dimension&, const std::string& name);
/// None = `otherwise`.
double quantity(const py::handle&, const Dimension&, const std::string& name, double otherwise);
/// One quantity, a list of them, or an array of numbers in SI.
std::vector<double> quantities(const py::handle&, const Dimension&, const std::string& name);

/// None = empty.
std::string text_or_none(const py::handle&);
/// One text or a list.
std::vector<std::string> texts(const py::handle&, const std::string& name);

/// A name, a path, or a Bed made in Python.
cli::Inputs read(const std::string& aircraft, const py::handle& bed, const py::handle& loads, const py::handle& tires);

/// A NumPy array that owns a copy.
py::array_t<double> array(const std::vector<double>&);

/// NaN stays NaN; used for numbers that may be missing.
inline py::object number(double value) { return py::float_(value); }

}  // namespace apc::python
