#include "loadtables/penetration_scale.h"

#include "apc/base/curve.h"
#include "apc/base/require.h"
#include "loadtables/load_table.h"

namespace apc::loadtables {

PenetrationScale penetration_scale(const TableTire& tire) {
  require(tire.diameter > 0.0 && tire.width > 0.0, "tire \"", tire.name, "\": diameter ", tire.diameter, " m, width ",
          tire.width, " m. Both must be positive");
  require(tire.curve_load.size() >= 2 && tire.curve_load.front() == 0.0 && tire.curve_deflection.front() == 0.0,
          "tire \"", tire.name, "\": its load-deflection curve must start at (0, 0) and have two points or more");
  for (std::size_t i = 1; i < tire.curve_load.size(); ++i)
    require(tire.curve_load[i] > tire.curve_load[i - 1], "tire \"", tire.name,
            "\": its load-deflection curve must increase, but ", tire.curve_load[i], " N follows ",
            tire.curve_load[i - 1], " N");
  require(tire.bottoming_load > 0.0, "tire \"", tire.name, "\": the bottoming load must be positive");
  const MonotoneCurve curve(tire.curve_deflection, tire.curve_load);
  PenetrationScale scale;
  scale.deflection = curve.inverse(0.8 * tire.bottoming_load);
  scale.diameter = tire.diameter;
  require(scale.deflection > 0.0 && scale.deflection < 0.5 * tire.diameter, "tire \"", tire.name, "\": deflects ",
          scale.deflection, " m at 80 % of its bottoming load, more than its radius");
  return scale;
}

}  // namespace apc::loadtables
