#include "sph_backend/fem/fem_press.h"

#include <chrono>
#include <cmath>

#include "sph_backend/fem/mesh_block.h"
#include "sph_backend/press_loop.h"

namespace apc::sph::fem {
PressResult press(const PressCase& given, const Elements& elements) {
  const auto begin = std::chrono::steady_clock::now();
  MeshSpec spec;
  spec.foam = given.foam, spec.size = given.spacing, spec.depth = given.depth, spec.half_width = given.width;
  spec.columns = std::max(1, static_cast<int>(std::lround(given.length / given.spacing)));
  spec.hold_bottom = false, spec.mirror_ends = true;
  spec.integration = elements.integration, spec.hourglass = elements.hourglass;
  spec.hourglass_factor = elements.hourglass_factor, spec.cfl = elements.cfl;
  Mesh mesh = make_mesh(spec);

  PressResult result;
  press_block(given, mesh, mesh.half_width * spec.columns * spec.size, result);
  result.compaction = largest_compaction(mesh);
  result.particles = static_cast<double>(mesh.nx) * mesh.ny * mesh.nz, result.steps = static_cast<double>(mesh.steps);
  result.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  result.particle_steps_per_s = static_cast<double>(mesh.element_steps) / result.wall_s;
  return result;
}

}  // namespace apc::sph::fem
