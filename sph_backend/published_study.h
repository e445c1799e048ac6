/// What the published study prints (M. Barsotti, Comparison of FEM and SPH for Modeling a Crushable Foam Aircraft
/// Arrestor Bed, tables 2, 3 and 4), in SI. NaN where a table has no entry.
#pragma once

#include <limits>
#include <string>

namespace apc::sph {

enum class Study { platen_1d, roller_2d, tire_3d, punch_2d, deck };
enum class Method { sph, fem };

struct Published {
  double extrapolated = std::numeric_limits<double>::quiet_NaN();
  double order = std::numeric_limits<double>::quiet_NaN();
  double gci = std::numeric_limits<double>::quiet_NaN();           ///< grid convergence index (table 3)
  double r2 = std::numeric_limits<double>::quiet_NaN();            ///< of the power fit (tables 2 and 4)
  double finest_error = std::numeric_limits<double>::quiet_NaN();  ///< at 1 in against the extrapolated value
};

/// Quantities: energy_rmse (platen); vertical, drag (roller, per unit of width); vertical, drag,
/// internal_energy_rate, hourglass_share (tire, half model; roller too has hourglass_share).
Published published(Study, Method, const std::string& quantity);

}  // namespace apc::sph
