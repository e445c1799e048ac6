#include "apc/simulation/table_tire.h"

namespace apc::simulation {

loadtables::TableTire table_tire(const aircraft::Tire& tire) {
  return {tire.name,
          tire.diameter,
          tire.width,
          tire.rated_load,
          tire.rated_deflection,
          tire.bottoming_load,
          tire.bottoming_deflection,
          tire.load_curve.x(),
          tire.load_curve.y()};
}

}  // namespace apc::simulation
