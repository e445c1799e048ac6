#include "sph_backend/foam.h"

#include <algorithm>
#include <cmath>

#include "apc/base/units.h"

namespace apc::sph {

double Foam::yield_stress(double strain) const {
  const double last = load_curve.x().back();
  if (strain <= last || load_curve.x().size() < 2) return load_curve(strain);
  return load_curve.y().back() + load_curve.slope(last - 1e-9) * (strain - last);
}

double Foam::lame_lambda() const {
  return youngs_modulus * poisson_ratio / ((1.0 + poisson_ratio) * (1.0 - 2.0 * poisson_ratio));
}

double Foam::shear_modulus() const { return 0.5 * youngs_modulus / (1.0 + poisson_ratio); }

double Foam::sound_speed() const { return std::sqrt((lame_lambda() + 2.0 * shear_modulus()) / density); }

Foam ideal_foam_50psi() {
  using namespace units;
  Foam foam;
  foam.name = "foam_50psi";
  foam.density = 3.75e-5 * lbf / (in * in * in * in);
  foam.youngs_modulus = 2000.0 * psi;
  foam.tension_cutoff = 10.0 * psi;
  foam.damping = 1e-4;
  foam.load_curve = LinearCurve({0.0, 0.85, 0.90, 1.0}, {50.0 * psi, 50.0 * psi, 550.0 * psi, 20550.0 * psi});
  return foam;
}

YieldTable tabulate(const Foam& foam) {
  YieldTable table;
  table.stress.resize(YieldTable::intervals + 1);
  for (int i = 0; i <= YieldTable::intervals; ++i)
    table.stress[i] = static_cast<float>(foam.yield_stress(static_cast<double>(i) / YieldTable::intervals));
  table.lowest = *std::min_element(table.stress.begin(), table.stress.end());
  return table;
}

}  // namespace apc::sph
