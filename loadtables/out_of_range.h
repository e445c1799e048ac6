/// Loads of contacts outside a table's range: speed and bed depth continue linearly from the nearest value inside, kept
/// positive; penetration beyond P_max stands on crushed foam (crushed_through.h), with the edge's loads continued
/// alike.
///
/// Positive: from half the load at the edge of the range on, a falling line becomes an exponential, φ(z) = ½ e^(2z − 1)
/// of its share z < ½ of that load; C¹.
#pragma once

#include "loadtables/crushed_through.h"
#include "loadtables/edge_sheet.h"

namespace apc::loadtables {

/// What all look-ups of a table beyond its edge share.
struct Edge {
  EdgeSheet sheet;
  HardBase base;
};

/// Whether a contact with penetration > 0 lies there.
bool out_of_range(const LoadTable::Data&, const TireContact&);
/// The load there, with derivatives; and without them, the same bits at less cost.
LoadWithSlopes load_out_of_range(const LoadTable::Data&, const Edge&, const TireContact&);
TireLoad plain_load_out_of_range(const LoadTable::Data&, const Edge&, const TireContact&);

}  // namespace apc::loadtables
