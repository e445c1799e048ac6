/// `design`: the bed for a fleet.
#include "apc/base/file.h"
#include "apc/cli/fleet_inputs.h"
#include "apc/python/arguments.h"
#include "apc/python/bindings.h"
#include "apc/python/call.h"
#include "apc/report/design_record.h"

namespace apc::python {
namespace {

design::Objective objective_of(const std::string& word) {
  using design::Objective;
  for (const auto each : {Objective::length, Objective::minimax, Objective::volume, Objective::speed})
    if (word == design::text(each)) return each;
  throw InputError("objective: \"" + word + "\" is no objective. Write length, minimax, volume or speed");
}

py::dict design(const std::string& fleet_name, const std::string& objective, const py::object& criterion,
                const py::object& length, const py::object& folder, double rtol, unsigned threads,
                const py::object& loads, const py::object& tires) {
  design::SizeOptions size;
  size.objective = objective_of(objective);
  const auto file = resolve(fleet_name, "designs/fleets", "fleet");
  report::DesignRecord record;
  record.fleet = design::load_fleet(file), record.fleet_text = read_text(file);
  const auto word = text_or_none(criterion);
  require(word.empty() || word == "limit" || word == "ultimate", "criterion: \"", word,
          "\" is no criterion. Write limit or ultimate");
  if (!word.empty())
    record.fleet.limits.criterion = word == "limit" ? design::Criterion::limit : design::Criterion::ultimate;
  size.length = quantity(length, dimension::length, "length", 0.0);
  require(size.length == 0 || size.objective == design::Objective::speed,
          "length: is given only with objective=\"speed\"; otherwise the length is what is looked for");
  require(rtol >= 1e-12 && rtol <= 1e-4, "rtol: ", rtol, " is outside 1e-12 to 1e-4");
  cli::Choice choice;
  choice.loads = text_or_none(loads), choice.tires = text_or_none(tires);
  auto loaded = cli::load_fleet_models(record.fleet, cli::note("fleet", file, record.fleet.source), choice);
  design::Problem problem;
  problem.fleet = record.fleet, problem.models = std::move(loaded.models);
  problem.solver.rtol = rtol, problem.threads = threads, problem.solve = simulation::simulate;

  const std::filesystem::path out_folder = text_or_none(folder);
  record.design = call([&] {
    if (out_folder.empty()) {
      study::Store store;
      return design::size_bed(problem, store, size);
    }
    study::Store store(out_folder / "design.store",
                       study::fingerprint(loaded.identity + APC_VERSION + "python" + std::to_string(rtol)));
    return design::size_bed(problem, store, size);
  });
  record.manifest = {std::string("apc ") + APC_VERSION,
                     "apc.design(\"" + fleet_name + "\", objective=\"" + objective + "\")", cli::utc_now(),
                     std::move(loaded.files)};
  auto& built = record.design.built.bed;
  built.name = record.fleet.name + ", " + objective,
  built.source = record.manifest.version + ": " + record.manifest.command;

  py::dict out;
  out["feasible"] = record.design.feasible, out["reason"] = record.design.reason;
  if (!out_folder.empty()) {
    write_text(out_folder / "design.json", report::design_json(record));
    write_text(out_folder / "design.html", report::design_page(record));
    if (record.design.feasible) write_text(out_folder / "bed.json", report::bed_json(built));
    out["file"] = (out_folder / "design.json").string();
  }
  if (!record.design.feasible) return out;
  out["bed"] = built, out["length"] = built.length(), out["volume"] = built.volume();
  out["speed_factor"] = record.design.speed_factor;
  py::list cases;
  for (const auto& each : record.design.cases) {
    py::dict one;
    const auto& asked = record.fleet.cases[each.fleet_case];
    one["aircraft"] = asked.aircraft, one["case"] = asked.name;
    one["asked_speed"] = asked.overrun.entry_speed * record.design.speed_factor;
    one["stop_distance"] = number(each.stop_distance), one["max_exit_speed"] = each.max_exit_speed;
    one["arrest_speed"] = each.arrest_speed, one["use"] = each.use;
    one["active_constraint"] = design::describe(each.active, record.fleet);
    cases.append(one);
  }
  out["cases"] = cases;
  const auto& certificate = record.design.certificate;
  py::dict shown;
  shown["agreed"] = certificate.agreed, shown["difference"] = certificate.difference;
  out["certificate"] = shown;
  return out;
}

}  // namespace

void bind_design(py::module_& module) {
  const py::none none;
  module.def(
      "design", &design, py::arg("fleet"), py::kw_only(), py::arg("objective") = "length", py::arg("criterion") = none,
      py::arg("length") = none, py::arg("folder") = none, py::arg("rtol") = 1e-7, py::arg("threads") = 0u,
      py::arg("loads") = none, py::arg("tires") = none,
      R"(Sizes a bed for a fleet (shipped name or apc-fleet/1 file). A dict: feasible, reason (when not), bed (a Bed, in
blocks as built), length (m), volume (m³), cases[] (stop_distance, max_exit_speed, active_constraint, …),
certificate (agreed, difference of the two methods).

objective  "length", "volume", "minimax" or "speed" (then `length` is given)
criterion  "limit" or "ultimate", instead of the fleet file's
folder     keeps finished overruns (the same call continues after ^C) and gets design.json, design.html, bed.json

Raises InputError; KeyboardInterrupt after ^C. No bed within the limits is a result, not an error.)");
}

}  // namespace apc::python
