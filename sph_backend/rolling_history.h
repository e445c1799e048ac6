/// Averages of a rolling run over bins of travel, and what they say: the loads of the last two windows, and whether
/// those windows agree. The same for particles and for finite elements.
#pragma once

#include <vector>

#include "sph_backend/tire.h"
#include "sph_backend/tire_contact.h"
#include "sph_backend/tire_rig.h"

namespace apc::sph {

inline constexpr std::size_t bins_per_window = 4;

/// Sums since the last bin of the history was closed.
struct RollingSums {
  double drag = 0.0, vertical = 0.0, spin = 0.0, deflection = 0.0;
  double steps = 0.0, distance = 0.0, internal = 0.0;
};

/// Adds one step of length `dt`; closes a bin after `bin` of travel. `internal` collects the foam's internal energy at
/// the end of each bin.
void sample(RollingSums&, RollingHistory&, std::vector<double>& internal, double bin, double dt, double time,
            const AxleState&, const Tire&, const ContactResult&, double internal_energy);

/// Means over the last two windows, and the change between them.
void measure(const RollingHistory&, const std::vector<double>& internal, RollingResult&);

/// The last two windows agree within the case's tolerances.
bool settled(const RollingCase&, const RollingResult&);

/// Once per full bin of the history, from two windows behind the transient on: steady? Sets the result's state.
bool judge(const RollingCase&, const RollingHistory&, const std::vector<double>& internal, std::size_t& judged,
           RollingResult&);

/// Last word on the state: load beyond the tire model, open energy account, or why it did not settle.
void conclude(const RollingCase&, RollingResult&);

}  // namespace apc::sph
