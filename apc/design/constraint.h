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
  int window = -1;             ///< which of the numbers of windows_of(); −1 = the peak anywhere
  std::string what;            ///< for slope and bound: which
};

/// "CRJ-200, landing weight: nose drag".
std::string describe(const Constraint&, const Fleet&);

/// Edges of windows along the nose wheel's way: fine ones for the nose gear's drag, which holds most designs in several
/// places at once, coarse ones for other loads. Empty = peaks anywhere only.
struct Watch {
  std::vector<double> fine, coarse;
};

/// One overrun reduced to what a design needs.
struct Figures {
  double distance = 0.0;    ///< m, nose wheel at rest; beyond the bed continued in proportion to v² when it left it
  std::vector<double> use;  ///< in the order of load_constraints
  std::vector<std::vector<double>> windows;  ///< per load constraint: use in each of its windows, at edges, at the end
};

/// How many numbers a load constraint has: of E edges E − 1 windows, then the load at each edge and at the end; 1 when
/// only its peak anywhere is known.
std::size_t windows_of(const Constraint&, const Watch&);

/// The load limits of one case that are known: drag and vertical load of each gear, decelerations, range of the tables.
std::vector<Constraint> load_constraints(const Fleet&, std::size_t fleet_case, const simulation::Model&);

/// The largest use of any load limit; history needed when the tables' range counts.
double worst_use(const simulation::Result&, const simulation::Model&, const Limits&);

/// Windows need a history.
Figures figures(const simulation::Result&, const simulation::Model&, const Limits&, double bed_length, const Watch&);

}  // namespace apc::design
