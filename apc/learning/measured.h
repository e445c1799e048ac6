/// Measured runs as data: signals, surveys, stops, and what is known about their errors. SI throughout.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "apc/effects/alterations.h"
#include "apc/simulation/simulate.h"

namespace apc::learning {

enum class Quantity {
  speed,
  acceleration_x,
  acceleration_z,
  pitch,
  pitch_rate,
  nose_stroke,
  main_stroke,
  nose_drag,
  nose_vertical,
  main_drag,
  main_vertical,
  nose_spin,
  main_spin,
  nose_distance,
};
const std::string& name_of(Quantity);
Dimension dimension_of(Quantity);
std::optional<Quantity> quantity_named(const std::string&);

/// One recorded signal: samples that exist, in order of time.
struct Channel {
  std::string column, unit;  ///< as in the file: "ax", "g"
  Quantity quantity = Quantity::speed;
  double noise = 0.0;  ///< one standard deviation
  double bias = 0.0;   ///< prior standard deviation of a constant error
  double lag = 0.0;    ///< root mean square of the delay, s
  double scale = 0.003;
  double lever_arm = 0.0;  ///< m forward of the centre of gravity
  std::vector<double> time, value;
};

/// Rut depths along the way; NaN = no reading.
struct Survey {
  std::vector<double> distance, nose_rut, main_rut;
  double noise = 0.015;
};

struct Uncertainty {
  double mass = 0.0, cg = 0.0, pitch_inertia = 0.0, entry_speed = 0.0, wind = 0.0, clock = 0.01;
};

struct Run {
  std::string id, lane, date;
  simulation::Overrun overrun;
  effects::Conditions conditions;
  Uncertainty uncertainty;
  bool mass_known = true;
  std::vector<Channel> channels;
  std::optional<Survey> survey;
  std::optional<double> stop, exit_speed;
  double stop_noise = 0.3;
  std::filesystem::path file;

  const Channel* find(Quantity) const;
};

/// What was found wrong with the data, and what was done about it.
struct DataRemark {
  std::string run, channel, text;
  enum class Action { noted, repaired, channel_dropped, run_set_aside } action = Action::noted;
};

/// A folder: one model and the runs measured against it.
struct Case {
  std::string title;
  std::filesystem::path folder;
  aircraft::Aircraft aircraft;
  bed::Bed bed;
  std::vector<loadtables::LoadTable> tables;
  std::vector<double> drag_rms, vertical_rms;  ///< per table in `tables`, as quoted
  std::vector<Run> runs, held_out;
  double block_strength = 0.08, correlation = 2.4;  ///< quoted scatter: of the logarithm; m
  double bed_strength = 0.04;  ///< deviation of the logarithm of the whole bed's strength from its data sheet
  std::vector<DataRemark> remarks;
};

/// Reads "apc-case/1". Runs that cannot be used are set aside with a remark; InputError when the model cannot be read
/// or no usable run is left. `aliases` (optional file, schema "apc-aliases/1") maps foreign column names and units.
Case load_case(const std::filesystem::path& folder_or_file, const std::optional<std::filesystem::path>& aliases = {});

}  // namespace apc::learning
