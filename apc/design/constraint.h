/// What limits a bed, as numbers "use" = value/limit that must stay at or below 1.
#pragma once

#include <string>
#include <vector>

#include "apc/design/fleet.h"

namespace apc::design {

enum class Kind {
  stop,                ///< comes to rest within the length
  drag,                ///< gear drag per strut
  vertical,            ///< gear vertical load per strut
  deceleration,        ///< peak
  deceleration_100ms,  ///< largest mean over 0.1 s
  table_range,         ///< penetration over the greatest one the tables were fitted to
  slope,               ///< change of depth per length
  bound,               ///< a variable at the edge of the space of beds
};

struct Constraint {
  Kind kind = Kind::stop;
  std::size_t fleet_case = 0;  ///< index into Fleet::cases
  std::string gear;            ///< "nose"; empty where no gear is meant
  int place = -1;              ///< drag at one of the places figures() was asked for; −1 = anywhere
  std::string what;            ///< for slope and bound: which
};

/// "CRJ-200, landing weight: nose drag".
std::string describe(const Constraint&, const Fleet&);

/// One overrun reduced to what a design needs.
struct Figures {
  double distance = 0.0;    ///< m, nose wheel at rest; beyond the bed continued in proportion to v² when it left it
  std::vector<double> use;  ///< in the order of load_constraints
  std::vector<double> nose_use;  ///< drag of the nose gear at given places
};

/// The load limits of one case that are known: drag and vertical load of each gear, decelerations, range of the tables.
std::vector<Constraint> load_constraints(const Fleet&, std::size_t fleet_case, const simulation::Model&);

/// The largest use of any load limit; history needed when the tables' range counts.
double worst_use(const simulation::Result&, const simulation::Model&, const Limits&);

/// `places`: distances of the nose wheel at which its gear's drag is wanted (needs a history). Beyond the last metre
/// before the stop the drag there is taken, so that a stop which moves past a place changes nothing abruptly.
Figures figures(const simulation::Result&, const simulation::Model&, const Limits&, double bed_length,
                const std::vector<double>& places);

}  // namespace apc::design
