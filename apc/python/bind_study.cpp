/// `study`: every combination of aircraft, bed, speed, mass, braking and strength.
#include <limits>
#include <map>

#include "apc/python/arguments.h"
#include "apc/python/bindings.h"
#include "apc/python/call.h"
#include "apc/report/design_record.h"
#include "apc/study/sweep.h"

namespace apc::python {
namespace {

/// One column per quantity, one row per case.
class Columns {
 public:
  void number(const char* name, double value) { numbers_[name].push_back(value); }
  void text(const char* name, const std::string& value) { texts_[name].append(value); }
  py::dict dict() const {
    py::dict out;
    for (const auto& [name, list] : texts_) out[py::str(name)] = py::module_::import("numpy").attr("array")(list);
    for (const auto& [name, list] : numbers_) out[py::str(name)] = array(list);
    return out;
  }

 private:
  std::map<std::string, std::vector<double>> numbers_;
  std::map<std::string, py::list> texts_;
};

py::dict study(const py::object& aircraft, const py::object& beds, const py::object& speeds, const py::object& masses,
               const py::object& braking, const py::object& strengths, const py::object& store_file, double rtol,
               unsigned threads, const py::object& loads, const py::object& tires) {
  std::vector<simulation::Model> models;
  std::string identity = APC_VERSION;
  py::list each_bed;
  if (py::isinstance<py::str>(beds) || py::isinstance<bed::Bed>(beds))
    each_bed.append(beds);
  else
    each_bed = py::list(beds);
  for (const auto& plane : texts(aircraft, "aircraft"))
    for (const auto& bed : each_bed) {
      auto inputs = read(plane, bed, loads, tires);
      for (const auto& file : inputs.files) identity += file.sha256;
      identity += report::bed_json(inputs.model.bed);
      models.push_back(std::move(inputs.model));
    }
  require(!models.empty(), "bed: is empty");
  study::Axes axes;
  axes.speeds = quantities(speeds, dimension::speed, "speeds");
  axes.mass_factors = {1.0};
  if (!masses.is_none()) axes.masses = quantities(masses, dimension::mass, "masses");
  axes.brakings = quantities(braking, dimension::none, "braking");
  axes.strengths = quantities(strengths, dimension::none, "strengths");
  for (const double each : axes.speeds) require(each > 2 && each < 80, "speeds: ", each, " m/s is outside 2 to 80 m/s");
  for (const double each : axes.brakings) require(each >= 0 && each <= 1, "braking: ", each, " is outside 0 to 1");
  for (const double each : axes.strengths)
    require(each >= 0.2 && each <= 3, "strengths: ", each, " is outside 0.2 to 3");
  study::SweepOptions options;
  options.solver.rtol = rtol, options.threads = threads;
  const auto file = text_or_none(store_file);
  const auto results = call([&] {
    const auto cases = study::combinations(models, axes);
    if (file.empty()) {
      study::Store store;
      return study::run(models, cases, simulation::simulate, store, options);
    }
    study::Store store(file, study::fingerprint(identity + std::to_string(rtol)));
    return study::run(models, cases, simulation::simulate, store, options);
  });
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  Columns out;
  for (const auto& each : results) {
    const auto& model = models[each.input.model];
    const auto& run = each.input.overrun;
    const bool good = each.failure.empty();
    out.text("aircraft", model.aircraft.name), out.text("bed", model.bed.name);
    out.text("outcome", good ? simulation::text(each.result.outcome) : "gave_up");
    out.number("speed", run.entry_speed), out.number("mass", run.mass > 0 ? run.mass : model.aircraft.mass);
    out.number("braking", run.braking), out.number("strength", run.alterations.bed_strength);
    out.number("stop_distance", good ? each.result.stop_distance : none);
    out.number("exit_speed", good ? each.result.exit_speed : none);
    out.number("peak_deceleration", good ? each.result.peak_deceleration : none);
    out.number("worst_margin", good ? study::worst_margin(each.result, study::Criterion::limit) : none);
  }
  return out.dict();
}

}  // namespace

void bind_study(py::module_& module) {
  const py::none none;
  module.def(
      "study", &study, py::arg("aircraft"), py::arg("bed"), py::arg("speeds"), py::kw_only(), py::arg("masses") = none,
      py::arg("braking") = 0.0, py::arg("strengths") = 1.0, py::arg("store") = none, py::arg("rtol") = 1e-6,
      py::arg("threads") = 0u, py::arg("loads") = none, py::arg("tires") = none,
      R"(Every combination of the lists, each a full overrun by the fast method, on all cores. A dict of arrays of shape
(cases,), speeds running fastest: aircraft, bed, outcome ("stopped", "left_bed", "gear_limit", "pitched_over", "gave_up"), speed,
mass, braking, strength, stop_distance (m; NaN when it left the bed), exit_speed, peak_deceleration, worst_margin
(limit/peak − 1, the smallest of all gears; NaN without a known limit).

store   a file that keeps finished cases: after ^C or a crash the same call continues with them

Raises InputError; KeyboardInterrupt after ^C.)");
}

}  // namespace apc::python
