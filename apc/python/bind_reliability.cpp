/// `reliability`: probability of arrest over scatter.
#include "apc/cli/reliability_run.h"

#include "apc/base/file.h"
#include "apc/python/arguments.h"
#include "apc/python/bindings.h"
#include "apc/python/call.h"

namespace apc::python {
namespace {

py::tuple estimate(const reliability::Estimate& from) { return py::make_tuple(from.value, from.low, from.high); }

py::dict indices(const std::vector<reliability::SobolIndex>& from, double unexplained) {
  py::dict out;
  for (std::size_t i = 0; i < from.size(); ++i)
    out[reliability::scattered_names()[i]] = py::make_tuple(from[i].first, from[i].total);
  out["unexplained"] = unexplained;
  return out;
}

py::list assess(const py::object& design, const py::object& folder, long samples, long seed, const py::object& scatter,
                unsigned threads, const py::object& loads, const py::object& tires) {
  cli::ReliabilityAsk ask;
  ask.of.design = text_or_none(design), ask.of.out = text_or_none(folder), ask.of.threads = threads;
  ask.of.choice.loads = text_or_none(loads), ask.of.choice.tires = text_or_none(tires);
  ask.scatter = text_or_none(scatter), ask.samples = samples, ask.seed = seed;
  ask.command = "apc.reliability(\"" + ask.of.design + "\", samples=" + std::to_string(samples) + ")";
  const auto record = call([&] { return cli::run_reliability(ask); });
  write_text(ask.of.out / "reliability.json", report::reliability_json(record));
  write_text(ask.of.out / "reliability.html", report::reliability_page(record));
  py::list out;
  for (std::size_t k = 0; k < record.results.size(); ++k) {
    const auto& from = record.results[k];
    py::dict each;
    each["case"] = record.cases[k], each["asked_speed"] = record.asked_speeds[k];
    each["samples"] = from.samples, each["gave_up"] = from.gave_up, each["runs"] = from.runs;
    each["arrest"] = estimate(from.arrest), each["intact"] = estimate(from.intact);
    each["arrest_at_asked_speed"] = estimate(from.arrest_at_asked);
    each["intact_at_asked_speed"] = estimate(from.intact_at_asked);
    each["arrest_speed_975"] = from.arrest_speed_975, each["intact_speed_975"] = from.intact_speed_975;
    each["arrest_speeds"] = array(from.arrest_speeds), each["intact_speeds"] = array(from.intact_speeds);
    each["sobol_arrest_speed"] = indices(from.arrest_indices, from.arrest_unexplained);
    each["sobol_intact_speed"] = indices(from.intact_indices, from.intact_unexplained);
    out.append(each);
  }
  return out;
}

}  // namespace

void bind_reliability(py::module_& module) {
  const py::none none;
  module.def(
      "reliability", &assess, py::arg("design"), py::arg("folder"), py::kw_only(), py::arg("samples") = 1000,
      py::arg("seed") = 1, py::arg("scatter") = none, py::arg("threads") = 0u, py::arg("loads") = none,
      py::arg("tires") = none,
      R"(Probability of arrest and of arrest without damage of a finished design (design.json). One dict per case of its
fleet: arrest, intact, arrest_at_asked_speed, intact_at_asked_speed as (value, low, high) of the 95 % interval;
arrest_speeds, intact_speeds (sorted arrays of shape (samples,), m/s); arrest_speed_975 (97.5 % of the samples handle
at least this); sobol_…[INPUT] = (first, total) shares of variance.

folder   keeps finished samples (the same call continues after ^C) and gets reliability.json, reliability.html
scatter  an apc-scatter/1 file; default: estimates, listed in the record

Raises InputError; KeyboardInterrupt after ^C.)");
}

}  // namespace apc::python
