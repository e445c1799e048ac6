/// The Python module `_apc`, which the package `apc` wraps.
#include <pybind11/pybind11.h>

#include "apc/base/require.h"
#include "apc/python/bindings.h"

PYBIND11_MODULE(_apc, module) {
  using namespace apc;
  module.doc() = "Arrestor Prediction Code: aircraft in crushable arrestor beds. SI throughout.";
  module.attr("__version__") = APC_VERSION;
  pybind11::register_exception<InputError>(module, "InputError", PyExc_ValueError);
  pybind11::register_exception<SolveError>(module, "SolveError", PyExc_RuntimeError);
  python::bind_bed(module);
  python::bind_simulate(module);
  python::bind_study(module);
  python::bind_design(module);
  python::bind_reliability(module);
  python::bind_report(module);
}
