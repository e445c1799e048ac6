/// Energy account of a run with a tire: what the axle puts in, and every place where it goes. Each term is computed for
/// itself (none is the remainder of the others), so the residual measures the quality of the run.
#pragma once

#include <string>
#include <vector>

namespace apc::sph {

/// All in J, of the modelled half, since the start of the run.
struct EnergyAccount {
  double axle_work = 0.0;        ///< in: ∫ force · velocity of the axle
  double spin_work = 0.0;        ///< in: ∫ torque · spin while the spin is prescribed
  double foam_internal = 0.0;    ///< elastic and crushed
  double foam_kinetic = 0.0;     ///< now
  double viscosity = 0.0;        ///< artificial viscosity, which stands for crush shocks too
  double foam_damping = 0.0;     ///< rate damping of the material
  double hourglass = 0.0;        ///< against modes that one-point elements do not see; zero for particles
  double friction = 0.0;         ///< tire on foam
  double contact_penalty = 0.0;  ///< stored in the contact with tire and rigid plane, now
  double contact_damping = 0.0;
  double contact_radius = 0.0;  ///< taken up by the shrinking contact radius: crush of the outer half layer
  double tire_stored = 0.0;     ///< membrane and foundation, now
  double tire_kinetic = 0.0;    ///< tread, now
  double tire_damping = 0.0;
  double wheel_kinetic = 0.0;  ///< spin, now
  double removed = 0.0;        ///< kinetic energy that left with the window

  double input() const { return axle_work + spin_work; }
  double accounted() const {
    return foam_internal + foam_kinetic + viscosity + foam_damping + hourglass + friction + contact_penalty +
           contact_damping + contact_radius + tire_stored + tire_kinetic + tire_damping + wheel_kinetic + removed;
  }
  /// (input − accounted)/input.
  double residual() const { return input() != 0.0 ? (input() - accounted()) / input() : 0.0; }
};

/// One line of the account, J.
struct EnergyTerm {
  std::string name;
  double value = 0.0;
};
std::vector<EnergyTerm> energy_in(const EnergyAccount&);
/// The hourglass line only where there is one.
std::vector<EnergyTerm> energy_out(const EnergyAccount&);

}  // namespace apc::sph
