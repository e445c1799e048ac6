#include "sph_backend/material_json.h"

#include "apc/base/require.h"

namespace apc::sph {
namespace {

LinearCurve read_load_curve(const Json& curve) {
  const std::vector<double> strain = curve.numbers("strain"), stress = curve.quantities("stress", dimension::pressure);
  curve.check(strain.size() == stress.size(), "stress",
              concat("has ", stress.size(), " values for ", strain.size(), " strains. Give as many as strains."));
  curve.check(strain.size() >= 2, "strain", "has fewer than two points. Give at least the plateau and the lock.");
  for (std::size_t i = 0; i < strain.size(); ++i) {
    curve.check(strain[i] >= 0.0 && strain[i] <= 1.0, "strain",
                concat("contains ", strain[i], ". Volumetric strains lie between 0 and 1."));
    curve.check(i == 0 || strain[i] > strain[i - 1], "strain",
                concat("does not increase: ", strain[i], " follows ", strain[i == 0 ? 0 : i - 1],
                       ". Sort the points by strain."));
    curve.check(stress[i] > 0.0, "stress", concat("contains ", stress[i], " Pa. A crush stress is positive."));
  }
  curve.finish();
  return LinearCurve(strain, stress);
}

}  // namespace

FoamData read_foam(const Json& file) {
  file.schema("apc-material/1");
  FoamData data;
  Foam& foam = data.foam;
  foam.name = file.text("name");
  data.source = file.text("source");
  foam.density = file.quantity("density", dimension::density);
  foam.youngs_modulus = file.quantity("youngs_modulus", dimension::pressure);
  foam.poisson_ratio = file.number("poisson_ratio", 0.0);
  foam.tension_cutoff = file.quantity("tension_cutoff", dimension::pressure);
  foam.damping = file.number("damping", 0.0);
  file.check(foam.density > 0.0, "density", "is not positive. Give the density of the intact foam, e.g. \"25 pcf\".");
  file.check(foam.youngs_modulus > 0.0, "youngs_modulus",
             "is not positive. Give the modulus of the intact foam, e.g. \"2000 psi\".");
  file.check(foam.poisson_ratio >= 0.0 && foam.poisson_ratio < 0.5, "poisson_ratio", "must lie in [0, 0.5).");
  file.check(foam.tension_cutoff >= 0.0, "tension_cutoff",
             "is negative. Give the largest tensile stress, e.g. \"10 psi\".");
  file.check(foam.damping >= 0.0 && foam.damping <= 1.0, "damping", "must lie in [0, 1].");
  foam.load_curve = read_load_curve(file.object("load_curve"));
  file.check(foam.youngs_modulus > foam.load_curve.y().front(), "youngs_modulus",
             "is below the crush strength: the foam would reach full compaction elastically.");
  const Json nominal = file.object("nominal");
  data.nominal_strength = nominal.quantity("strength", dimension::pressure);
  data.nominal_density = nominal.quantity("density", dimension::density);
  data.bottoming_strain = nominal.number("bottoming_strain");
  nominal.check(data.bottoming_strain > 0.0 && data.bottoming_strain < 1.0, "bottoming_strain", "must lie in (0, 1).");
  nominal.finish();
  file.finish();
  return data;
}

FoamData load_foam(const std::filesystem::path& path) { return read_foam(read_json(path)); }

}  // namespace apc::sph
