/// The measured runs of the tutorials: what is hidden in each, and the seed that makes it again.
#pragma once

#include "apc/effects/catalogue.h"
#include "apc/effects/effect_json.h"
#include "tests/support/case_files.h"
#include "tests/support/surveyed_runs.h"

namespace apc::testing {

inline std::filesystem::path tutorial_folder(const std::string& name) {
  return std::filesystem::path(PROJECT_DIR) / "designs/cases" / name;
}

/// Instruments with the units of their files.
inline learning::Case with_units(learning::Case data) {
  for (auto& run : data.runs)
    for (auto& c : run.channels)
      c.unit = c.quantity == learning::Quantity::speed        ? "m/s"
               : c.quantity == learning::Quantity::pitch_rate ? "rad/s"
                                                              : "m/s^2";
  return data;
}

/// Frost: the first rows of blocks at half their strength. Not the catalogue's law: a step with a soft edge of 1 m.
inline effects::Applied frost(double rows_end, double loss) {
  effects::Effect e;
  e.id = "frost";
  e.parameters = {{"loss", "", dimension::none, 0.0, 1.0, 0.5, 0.0},
                  {"end", "m", dimension::length, 0.0, 50.0, 12.0, 0.0}};
  e.bed = [](const effects::TireState& state, effects::Values q, effects::TireChange& change) {
    change.strength *= 1.0 - q[0] * 0.5 * (1.0 - std::tanh((state.bed_distance - q[1]) / 0.5));
  };
  return {e, {loss, rows_end}};
}

inline SurveyedRuns tutorial_runs(unsigned seed) {
  SurveyedRuns wanted;
  wanted.seed = seed, wanted.block_strength = 0.05, wanted.correlation = 2.4, wanted.table_error = 0.01;
  wanted.ramp = 6.1;
  return wanted;
}

/// Everything is written that a user needs; `own` is the law of the tutorial on own effects.
inline void write_tutorial(const std::string& name, const std::string& title, const SurveyedRuns& wanted) {
  const CaseTexts texts{title, "B737-800", "20 in of 50 psi foam",
                        "made for a tutorial with this project's own simulator", "foam_50psi"};
  write_case(
      with_units(surveyed_case(wanted)), texts, [](const aircraft::Tire& tire) { return crush_law(tire); }, 0.02,
      tutorial_folder(name));
}

/// Two stops of the FAA's B727 in phenolic foam (White and Agrawal 1993). Nothing but speeds, stops and the bed's size
/// is published: the strength (30 psi, ± 30 %) is what stops the aircraft about there, scatter and instruments are
/// guesses.
inline void write_faa_pair() {
  learning::Case data;
  data.aircraft = shipped_aircraft("B727-100");
  data.bed = foam_bed(18 * units::in, 10 * units::ft, 680 * units::ft);
  data.bed.setback = 0.0, data.bed.width = 48 * units::ft, data.bed.block_length = 4 * units::ft;
  data.bed.nominal = bed::NominalMaterial{30 * units::psi, 40.0, 0.8};
  data.block_strength = 0.05, data.correlation = 1.2, data.bed_strength = 0.3;
  for (const auto& [speed, stop] : {std::pair{50.0, 420.0}, std::pair{60.0, 540.0}}) {
    learning::Run run;
    run.id = fmt::format("from_{:.0f}_kt", speed), run.lane = "A";
    run.overrun.mass = 135000 * units::lb, run.overrun.entry_speed = speed * units::kt;
    run.overrun.cg_behind_nose_gear = data.aircraft.cg_behind_nose_gear;
    run.overrun.pitch_inertia = data.aircraft.pitch_inertia, run.overrun.thrust = data.aircraft.idle_thrust;
    run.uncertainty = {0.01 * run.overrun.mass, 0.05, 0.03 * run.overrun.pitch_inertia, 0.15, 1.0, 0.01};
    run.stop = stop * units::ft, run.stop_noise = 1.0;
    data.runs.push_back(run);
  }
  write_case(
      data,
      {"FAA B727 in phenolic foam: two stops", "B727-100", "FAA phenolic foam bed, 680 ft x 48 ft x 18 in",
       "White and Agrawal, Soft Ground Arresting System for Airports, 1993 (size); strength, density and lead-in are "
       "guesses",
       "phenolic_foam"},
      [](const aircraft::Tire& tire) {
        auto law = crush_law(tire, 30 * units::psi);
        law.drag_factor = 1.1, law.inertia = 0.0, law.lock_up = 0.8;
        return law;
      },
      0.02, tutorial_folder("faa_b727"));
}

}  // namespace apc::testing
