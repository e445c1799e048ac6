#include "loadtables/edge_sheet.h"

namespace apc::loadtables {

EdgeSheet::EdgeSheet(const LoadTable::Data& data, double ratio) : depths_(data.depth.coefficients()) {
  const auto r = weights(data.ratio, ratio);
  const auto lines = static_cast<std::size_t>(data.speed.coefficients() * depths_);
  const auto length = static_cast<std::size_t>(data.ratio.coefficients()) * responses;
  coefficients_.resize(lines * numbers);
  for (std::size_t line = 0; line < lines; ++line)
    for (std::size_t m = 0; m < responses; ++m)
      for (std::size_t k = 0; k < 4; ++k) {
        const double c = data.coefficients[line * length + (static_cast<std::size_t>(r.first) + k) * responses + m];
        coefficients_[line * numbers + m] += r.value[k] * c;
        coefficients_[line * numbers + responses + m] += r.slope[k] * c;
      }
}

void EdgeSheet::sum(const double (&v)[4], int first_v, const double (&u)[4], int first_u,
                    double (&out)[numbers]) const {
  for (double& each : out) each = 0.0;
  for (int i = 0; i < 4; ++i) {
    const double* row = coefficients_.data() + static_cast<std::size_t>((first_v + i) * depths_ + first_u) * numbers;
    for (int j = 0; j < 4; ++j) {
      const double weight = v[i] * u[j];
      for (int m = 0; m < numbers; ++m) out[m] += weight * row[j * numbers + m];
    }
  }
}

}  // namespace apc::loadtables
