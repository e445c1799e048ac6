/// `Bed`: read from a file or made of arrays.
#include "apc/base/file.h"
#include "apc/base/json.h"
#include "apc/base/require.h"
#include "apc/python/arguments.h"
#include "apc/python/bindings.h"
#include "apc/report/design_record.h"

namespace apc::python {
namespace {

/// Checked as a file would be: written and read back.
bed::Bed made(const py::object& distance, const py::object& depth, const py::object& setback, const py::object& width,
              const std::string& material, const std::string& flush, double grade, const std::string& name) {
  bed::Bed bed;
  bed.name = name, bed.source = "made in Python", bed.material = material, bed.grade = grade;
  bed.setback = quantity(setback, dimension::length, "setback");
  bed.width = quantity(width, dimension::length, "width");
  bed.distance = quantities(distance, dimension::length, "distance");
  bed.depth = quantities(depth, dimension::length, "depth");
  require(flush == "top" || flush == "base", "flush: \"", flush, "\" is unknown. Write \"top\" or \"base\"");
  bed.flush = flush == "top" ? bed::Flush::top : bed::Flush::base;
  return bed::read_bed(parse_json(report::bed_json(bed), "Bed"));
}

}  // namespace

void bind_bed(py::module_& module) {
  py::class_<bed::Bed>(module, "Bed", "An arrestor bed. Lengths in m or as text with a unit; depth per distance.")
      .def(py::init(&made), py::arg("distance"), py::arg("depth"), py::kw_only(), py::arg("setback") = "50 ft",
           py::arg("width") = "150 ft", py::arg("material") = "foam_50psi", py::arg("flush") = "top",
           py::arg("grade") = 0.0, py::arg("name") = "bed")
      .def_readonly("name", &bed::Bed::name)
      .def_readonly("source", &bed::Bed::source)
      .def_readonly("material", &bed::Bed::material)
      .def_readonly("setback", &bed::Bed::setback, "m, from the pavement end to the leading edge")
      .def_readonly("width", &bed::Bed::width, "m")
      .def_readonly("grade", &bed::Bed::grade, "rise over run")
      .def_property_readonly("distance", [](const bed::Bed& bed) { return array(bed.distance); })
      .def_property_readonly("depth", [](const bed::Bed& bed) { return array(bed.depth); })
      .def_property_readonly("length", &bed::Bed::length, "m")
      .def_property_readonly("volume", &bed::Bed::volume, "m³")
      .def(
          "save",
          [](const bed::Bed& bed, const py::object& path) { write_text(text_or_none(path), report::bed_json(bed)); },
          py::arg("path"), "Writes an apc-bed/1 file.")
      .def("__repr__", [](const bed::Bed& bed) {
        return concat("<apc.Bed ", bed.name, ", ", bed.length(), " m, up to ", bed.maximum_depth(), " m of ",
                      bed.material, ">");
      });
  module.def(
      "load_bed", [](const std::string& name) { return bed::load_bed(resolve(name, "designs/beds", "bed")); },
      py::arg("name"), "A shipped bed by its name, or an apc-bed/1 file by its path.");
}

}  // namespace apc::python
