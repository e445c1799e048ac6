/// `report`: a design against the requirements.
#include "apc/base/file.h"
#include "apc/cli/report_run.h"
#include "apc/python/arguments.h"
#include "apc/python/bindings.h"
#include "apc/python/call.h"

namespace apc::python {
namespace {

py::dict report(const py::object& design, const py::object& folder, const py::object& site, const py::object& model,
                unsigned threads, const py::object& loads, const py::object& tires) {
  cli::ReportAsk ask;
  ask.of.design = text_or_none(design), ask.of.out = text_or_none(folder), ask.of.threads = threads;
  ask.of.choice.loads = text_or_none(loads), ask.of.choice.tires = text_or_none(tires);
  ask.site = text_or_none(site), ask.effects = text_or_none(model);
  ask.command = "apc report --design " + ask.of.design + (ask.site.empty() ? "" : " --site " + ask.site) +
                (ask.effects.empty() ? "" : " --model " + ask.effects);
  const auto record = call([&] { return cli::run_report(ask); });
  for (const auto& [name, text] : cli::texts_of(ask, record)) write_text(ask.of.out / name, text);
  py::list requirements;
  py::dict counts;
  for (const auto& each : report::findings(record)) {
    py::dict one;
    const char* verdict = report::text(each.verdict);
    one["clause"] = each.clause, one["clause_read"] = each.read, one["basis"] = each.basis, one["result"] = verdict;
    requirements.append(one);
    counts[verdict] = counts.contains(verdict) ? counts[verdict].cast<int>() + 1 : 1;
  }
  py::dict out;
  out["requirements"] = requirements, out["counts"] = counts;
  out["page"] = (ask.of.out / "report.html").string();
  return out;
}

}  // namespace

void bind_report(py::module_& module) {
  const py::none none;
  module.def(
      "report", &report, py::arg("design"), py::arg("folder"), py::kw_only(), py::arg("site") = none,
      py::arg("model") = none, py::arg("threads") = 0u, py::arg("loads") = none, py::arg("tires") = none,
      R"(The compliance report of a finished design (design.json) in `folder`: report.html, report.json, manifest.json,
with a `site` (name or apc-site/1 file) also site.geojson and site.kml. A dict: requirements[] (clause, clause_read,
basis, result: "pass", "fail", "not checked", "not verified"), counts per result, page (path).

model   learned effects (apc-model/1), whose influence is shown

Raises InputError; KeyboardInterrupt after ^C.)");
}

}  // namespace apc::python
