/// A table's edge at P_max, summed over the relative penetration once for all contacts: values and slopes by the ratio
/// of the four responses as one spline over speed × bed depth, an eighth of the whole table's sums.
#pragma once

#include <vector>

#include "loadtables/load_table_data.h"

namespace apc::loadtables {

struct EdgeSheet {
  static constexpr int numbers = 2 * static_cast<int>(responses);  ///< values, then slopes by the ratio

  EdgeSheet() = default;
  EdgeSheet(const LoadTable::Data&, double ratio);

  /// Σ v_i u_j c_ij with any two of the values' and slopes' weights.
  void sum(const double (&v)[4], int first_v, const double (&u)[4], int first_u, double (&out)[numbers]) const;

 private:
  int depths_ = 0;
  std::vector<double> coefficients_;  ///< (speed + 2) × (depth + 2) × numbers
};

}  // namespace apc::loadtables
