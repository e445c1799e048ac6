#include "apc/cli/formats.h"

namespace apc::cli {

FormatNote describe_material() {
  return {
      "apc-material/1",
      "a crushable foam as the particle back end models it",
      "JSON. Elastic until a principal stress reaches the load curve (crushing) or the tension cutoff; unloading is "
      "elastic. Strains are volumetric, compression positive.",
      {
          {"schema", "text", "required", "names the format", "\"apc-material/1\""},
          {"name", "text", "required", "as beds and load tables name it", "\"foam_50psi\""},
          {"source", "text", "required", "where the numbers come from", "\"platen tests, report 12\""},
          {"density", "density", "required", "of the intact foam", "\"25 pcf\""},
          {"youngs_modulus", "pressure", "required", "elastic, above the crushing strength", "\"2000 psi\""},
          {"poisson_ratio", "number", "optional; 0", "0 up to below 0.5", "0.0"},
          {"tension_cutoff", "pressure", "required", "largest tensile stress", "\"10 psi\""},
          {"damping", "number", "optional; 0", "rate damping, dimensionless", "1e-4"},
          {"load_curve.strain", "list of numbers", "required", "volumetric, increasing, 0 to 1", "[0, 0.85, 0.9, 1]"},
          {"load_curve.stress", "list of pressures", "required", "one per strain",
           "{\"unit\": \"psi\", \"values\": [50, 50, 550, 20550]}"},
          {"nominal.strength", "pressure", "required", "data-sheet crushing strength", "\"50 psi\""},
          {"nominal.density", "density", "required", "data-sheet density", "\"25 pcf\""},
          {"nominal.bottoming_strain", "number", "required", "where the foam is fully compacted", "0.85"},
      }};
}

FormatNote describe_sph() {
  return {
      "apc-sph/1",
      "one particle run: a free-rolling tire through a bed of foam, for \"apc sph run\"",
      "JSON. The tire is pressed to the penetration, accelerated, spun up, released, settled and measured. Half of "
      "it is modelled; loads are reported for the whole tire.",
      {
          {"schema", "text", "required", "names the format", "\"apc-sph/1\""},
          {"name", "text", "optional; the file's", "how reports call it", "\"H44.5, 70 kt, 24 in\""},
          {"source", "text", "optional", "why these numbers", "\"case of the published comparison\""},
          {"tire", "text or object", "required", "a name (apc list tires), or the keys of apc-tire/1",
           "\"H44.5x16.5-21\""},
          {"material", "text or object", "required", "shipped name, file, or the keys of apc-material/1",
           "\"foam_50psi\""},
          {"speed", "speed", "required", "of the axle", "\"70 kt\""},
          {"bed_depth", "length", "required", "of foam above a rigid plane", "\"24 in\""},
          {"penetration", "length", "required", "undeformed tire's lowest point below the surface", "\"16 in\""},
          {"spacing", "length", "optional; for tire and depth", "of the particles", "\"2 in\""},
          {"friction", "number", "optional; 0.3", "of tire on foam", "0.3"},
          {"spin", "text", "optional; \"free\"", "free, driven (held at v/R) or locked", "\"free\""},
          {"entry", "length", "optional; 0", "roll in at full speed along this way instead of pressing in at rest",
           "\"50 in\""},
          {"bed_half_width", "length", "optional; a tire width", "from the wheel plane outwards", "\"24 in\""},
          {"outer_wall", "true or false", "optional; true", "mirror plane at the half-width, or a free face", "true"},
          {"viscosity.alpha", "number", "optional; 0.1", "artificial viscosity, linear", "0.1"},
          {"viscosity.beta", "number", "optional; 2", "artificial viscosity, quadratic", "2.0"},
          {"cfl", "number", "optional; 0.35", "time step over h/(sound speed + speed)", "0.25"},
          {"longest", "length", "optional; ten radii", "travel after which a run counts as unsettled", "\"220 in\""},
      }};
}

}  // namespace apc::cli
