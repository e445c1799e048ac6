#include "apc/python/arguments.h"

#include <cmath>

#include "apc/base/require.h"
#include "apc/report/design_record.h"

namespace apc::python {

double quantity(const py::handle& value, const Dimension& dimension, const std::string& name) {
  if (py::isinstance<py::str>(value)) try {
      return parse_quantity(value.cast<std::string>(), dimension);
    } catch (const InputError& reason) {
      throw InputError(name + ": " + reason.what());
    }
  const bool number = py::isinstance<py::float_>(value) || py::isinstance<py::int_>(value) ||
                      (py::hasattr(value, "__float__") && !py::isinstance<py::bool_>(value));
  require(number, name, ": is no quantity. Write text with a unit, such as \"", name_of(dimension).example,
          "\", or a number in SI");
  const double out = py::float_(py::reinterpret_borrow<py::object>(value));
  require(std::isfinite(out), name, ": is not finite");
  return out;
}

double quantity(const py::handle& value, const Dimension& dimension, const std::string& name, double otherwise) {
  return value.is_none() ? otherwise : quantity(value, dimension, name);
}

std::vector<double> quantities(const py::handle& value, const Dimension& dimension, const std::string& name) {
  std::vector<double> out;
  if (py::isinstance<py::str>(value) || !py::hasattr(value, "__iter__")) return {quantity(value, dimension, name)};
  for (const auto& each : py::reinterpret_borrow<py::iterable>(value)) out.push_back(quantity(each, dimension, name));
  require(!out.empty(), name, ": is empty");
  return out;
}

std::string text_or_none(const py::handle& value) {
  return value.is_none() ? std::string() : py::str(value).cast<std::string>();
}

std::vector<std::string> texts(const py::handle& value, const std::string& name) {
  if (py::isinstance<py::str>(value)) return {value.cast<std::string>()};
  std::vector<std::string> out;
  require(py::hasattr(value, "__iter__"), name, ": is neither a name nor a list of names");
  for (const auto& each : py::reinterpret_borrow<py::iterable>(value)) out.push_back(py::str(each).cast<std::string>());
  require(!out.empty(), name, ": is empty");
  return out;
}

cli::Inputs read(const std::string& aircraft, const py::handle& bed, const py::handle& loads, const py::handle& tires) {
  cli::Choice choice;
  choice.aircraft = aircraft, choice.loads = text_or_none(loads), choice.tires = text_or_none(tires);
  if (!py::isinstance<bed::Bed>(bed)) {
    choice.bed = py::str(bed).cast<std::string>();
    return cli::read_inputs(choice);
  }
  return cli::read_inputs(choice, bed.cast<bed::Bed>(), {"bed", "Bed", "", "made in Python"});
}

py::array_t<double> array(const std::vector<double>& values) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

}  // namespace apc::python
