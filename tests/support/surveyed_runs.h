/// Surveyed runs of our own making: simulated overruns read off as instruments would, with noise, scatter of the
/// blocks, and an effect or none.
#pragma once

#include <random>

#include "apc/learning/measured.h"
#include "tests/support/simulation_models.h"

namespace apc::testing {

struct SurveyedRuns {
  std::vector<double> speeds = {20.0, 28.0, 34.0}, masses = {50000.0, 62000.0, 70000.0};
  std::vector<effects::Applied> hidden;
  double block_strength = 0.06, correlation = 3.0;  ///< of the logarithm; m
  double table_error = 0.0;  ///< rms of the tables' errors: mean and slope along the speed at three penetrations
  double accelerometer_scale = 1.0;   ///< what the accelerometers read along x, × the truth
  double accelerometer_offset = 0.0;  ///< m/s², what they read along x beyond that, as when tilted
  double sinking = 1.7;               ///< response to sinking, × a rigid wheel's: what SPH gives flexible tires
  double ramp = 15.24;                ///< m
  unsigned seed = 1;
};

inline learning::Channel channel(learning::Quantity quantity, double noise, double bias,
                                 const std::vector<double>& time, const std::vector<double>& value, int every,
                                 std::mt19937& random) {
  learning::Channel c;
  c.column = learning::name_of(quantity), c.quantity = quantity;
  c.noise = noise, c.bias = bias, c.lag = 0.005;
  std::normal_distribution<double> one;
  const double off = bias * one(random);
  for (std::size_t i = 0; i < time.size(); i += static_cast<std::size_t>(every))
    c.time.push_back(time[i]), c.value.push_back(value[i] + off + noise * one(random));
  return c;
}

/// One overrun as a measured run; instruments at 100 Hz (speed 10 Hz), survey every half metre.
inline learning::Run surveyed_run(const simulation::Model& model, const SurveyedRuns& wanted, std::size_t r,
                                  const std::vector<effects::TableError>& table_errors, std::mt19937& random) {
  using learning::Quantity;
  std::normal_distribution<double> one;
  learning::Run run;
  run.id = "run" + std::to_string(r + 1), run.lane = "A";
  run.overrun.entry_speed = wanted.speeds[r], run.overrun.mass = wanted.masses[r];
  run.overrun.cg_behind_nose_gear = model.aircraft.cg_behind_nose_gear;
  run.overrun.pitch_inertia = model.aircraft.pitch_inertia * wanted.masses[r] / model.aircraft.mass;
  run.uncertainty = {0.01 * wanted.masses[r], 0.02, 0.03 * run.overrun.pitch_inertia, 0.2, 0.8, 0.01};

  simulation::Overrun truth = run.overrun;
  truth.sinking = {wanted.sinking, 0.0};
  truth.alterations.effects = wanted.hidden;
  truth.alterations.table_errors = table_errors;
  for (std::size_t g = 0; g < model.aircraft.gears.size(); ++g) {
    effects::StrengthProfile blocks{1.0, {}};
    const double kept = std::exp(-1.0 / wanted.correlation);
    double value = wanted.block_strength * one(random);
    for (int i = 0; i < 400; ++i) {
      blocks.log_strength.push_back(value);
      value = kept * value + wanted.block_strength * std::sqrt(1.0 - kept * kept) * one(random);
    }
    truth.alterations.strength.push_back(blocks);
  }
  simulation::Options options;
  options.method = simulation::Method::fast;
  options.sampling = 0.01;
  const simulation::Result result = simulation::simulate(model, truth, options);
  const simulation::History& h = result.history;
  std::vector<double> forward = h.acceleration_x;
  for (double& a : forward) a = a * wanted.accelerometer_scale + wanted.accelerometer_offset;
  run.channels = {channel(Quantity::speed, 0.1, 0.05, h.time, h.speed, 10, random),
                  channel(Quantity::acceleration_x, 0.3, 0.1, h.time, forward, 1, random),
                  channel(Quantity::acceleration_z, 0.5, 0.1, h.time, h.acceleration_z, 1, random),
                  channel(Quantity::pitch_rate, 0.005, 0.002, h.time, h.pitch_rate, 1, random)};
  learning::Survey survey;
  for (double s = 0.0; s < result.stop_distance; s += 0.5) {
    survey.distance.push_back(s);
    for (std::size_t g = 0; g < 2; ++g) {
      const auto& gear = h.gears[g];
      const auto at = static_cast<std::size_t>(std::lower_bound(gear.distance.begin(), gear.distance.end(), s) -
                                               gear.distance.begin());
      const double rut = at < gear.rut.size() ? gear.rut[at] + survey.noise * one(random) : std::nan("");
      (model.aircraft.gears[g].is_nose() ? survey.nose_rut : survey.main_rut).push_back(rut);
    }
  }
  run.survey = survey;
  run.stop = result.stop_distance + 0.3 * one(random);
  return run;
}

/// A B737-800 in 20 in of 50 psi foam.
inline learning::Case surveyed_case(const SurveyedRuns& wanted) {
  bed::Bed bed = foam_bed(0.508, wanted.ramp, 300.0);
  bed.nominal = bed::NominalMaterial{50 * units::psi, 320.0, 0.85};
  bed.block_length = 1.22;
  const simulation::Model model = foam_model("B737-800", bed);
  learning::Case data;
  data.title = "made for a test";
  data.aircraft = model.aircraft, data.bed = model.bed, data.tables = model.tables;
  data.drag_rms.assign(data.tables.size(), 0.03), data.vertical_rms = data.drag_rms;
  data.block_strength = wanted.block_strength, data.correlation = wanted.correlation;
  std::mt19937 random(wanted.seed);
  std::vector<effects::TableError> errors(wanted.table_error > 0.0 ? data.tables.size() : 0);
  std::normal_distribution<double> one;
  for (auto& error : errors)
    for (auto* response : {&error.drag, &error.vertical})
      for (std::size_t j = 0; j < 3; ++j) {
        const double mean = wanted.table_error * one(random), slope = wanted.table_error * one(random);
        for (std::size_t i = 0; i < 3; ++i)
          (*response)[3 * i + j] = mean + slope * (i == 0 ? -0.68 : i == 1 ? 0.0 : 1.0);
      }
  for (std::size_t r = 0; r < wanted.speeds.size(); ++r)
    data.runs.push_back(surveyed_run(model, wanted, r, errors, random));
  return data;
}

}  // namespace apc::testing
