/// What a bed must do and what it may be: the aircraft that use the runway with their weights, centres of gravity,
/// braking and speeds; the limits their loads must stay below; and the space of beds to choose from.
/// Schema "apc-fleet/1".
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "apc/base/json.h"
#include "apc/bed/bed.h"
#include "apc/simulation/simulate.h"
#include "apc/study/sweep.h"

namespace apc::design {

using study::Criterion;

/// One overrun the bed must handle. `overrun.entry_speed` is the speed it shall be stopped from.
struct FleetCase {
  std::string aircraft;  ///< as the file names it: a shipped name or a path
  std::string name;      ///< "maximum take-off weight, braked"
  simulation::Overrun overrun;
};

/// What loads and decelerations must stay below, besides the gear limits of the aircraft files.
struct Limits {
  Criterion criterion = Criterion::limit;
  double deceleration = 0.0;        ///< m/s², peak; 0 = no limit
  double deceleration_100ms = 0.0;  ///< m/s², largest mean over 0.1 s; 0 = no limit
  std::vector<std::string> loads;   ///< gear loads that count: "nose drag", "main vertical", …; empty = all known
  bool table_range = true;          ///< penetration stays within the range the load tables were fitted in
};

/// The beds to choose from. Depth nodes lie at even distances behind the ramp; the last depth continues to the end.
struct BedSpace {
  std::string material;
  bed::Flush flush = bed::Flush::top;
  double setback = 0.0, width = 0.0, grade = 0.0;
  double minimum_depth = 0.0, maximum_depth = 0.0;
  double minimum_ramp = 0.0, maximum_ramp = 0.0;  ///< length from depth 0 to the first node
  double maximum_slope = 0.1;                     ///< |change of depth| per length, everywhere
  double maximum_length = 0.0;
  int nodes = 4;                                             ///< depths to choose, ramp end included
  double block_length = 0.0, block_width = 0.0, step = 0.0;  ///< of blocks as built; step = of their depths
};

struct Fleet {
  std::string name, source;
  std::vector<FleetCase> cases;
  double floor_speed = 0.0;  ///< m/s: every case must be stopped from at least this speed, whatever the objective
  Limits limits;
  BedSpace bed;
};

/// Throws InputError: file, path, value, remedy. Limits that exclude one another are refused here.
Fleet load_fleet(const std::filesystem::path&);
Fleet read_fleet(const Json&);

/// "nose drag, main drag" or "all known gear loads": what the design watched.
std::string counted_loads(const Limits&);

/// Whether a load of a gear counts; "main" stands for every gear that is not the nose gear.
bool counts(const Limits&, const std::string& gear, const std::string& load);

/// The names of the aircraft, each once, in the order of the file.
std::vector<std::string> aircraft_names(const Fleet&);

}  // namespace apc::design
