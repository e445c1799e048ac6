#include "sph_backend/energy.h"

namespace apc::sph {

std::vector<EnergyTerm> energy_in(const EnergyAccount& e) {
  return {{"work of the axle", e.axle_work}, {"work of spinning up", e.spin_work}};
}

std::vector<EnergyTerm> energy_out(const EnergyAccount& e) {
  std::vector<EnergyTerm> terms{{"foam, internal", e.foam_internal},
                                {"foam, kinetic", e.foam_kinetic},
                                {"artificial viscosity", e.viscosity},
                                {"foam damping", e.foam_damping},
                                {"friction", e.friction},
                                {"contact, stored", e.contact_penalty},
                                {"contact damping", e.contact_damping},
                                {"contact radius", e.contact_radius},
                                {"tire, stored", e.tire_stored},
                                {"tire, kinetic", e.tire_kinetic},
                                {"tire damping", e.tire_damping},
                                {"wheel spin", e.wheel_kinetic},
                                {"left with the window", e.removed}};
  if (e.hourglass != 0.0) terms.push_back({"hourglass control", e.hourglass});
  return terms;
}

}  // namespace apc::sph
