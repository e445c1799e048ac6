#include "sph_backend/press_rig.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "sph_backend/foam_bed.h"

namespace apc::sph {
namespace {

/// Platen on the upper layers: penalty against the shrinking contact radius, as on a tire (tire_contact.h).
struct Platen {
  double height = 0.0, speed = 0.0;  ///< speed > 0 downwards
  double stiffness = 0.0, damping = 0.0;
  double force = 0.0, stored = 0.0, radius_work = 0.0, damped = 0.0;
};

double contact_radius(const Bed& bed, float stretch) {
  return 0.5 * bed.layer / (static_cast<double>(stretch) * stretch * stretch);
}

void push(Bed& bed, Platen& platen, const std::vector<float>& stretch_before) {
  platen.force = platen.stored = 0.0;
  const Particles& p = bed.particles;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.id[i] < 0) continue;
    const double radius = contact_radius(bed, p.stretch[i]), overlap = p.z[i] + radius - platen.height;
    if (overlap <= 0.0) continue;
    const double elastic = platen.stiffness * overlap;
    const double closing = std::max(platen.damping * (p.vz[i] + platen.speed), -elastic);
    bed.acceleration[2][i] -= static_cast<float>((elastic + closing) / bed.mass);
    const double mean_vz = p.vz[i] + 0.5 * bed.dt * bed.acceleration[2][i];
    platen.force += elastic + closing;
    platen.stored += 0.5 * platen.stiffness * overlap * overlap;
    platen.damped += bed.dt * closing * (mean_vz + platen.speed);
    platen.radius_work -= elastic * (radius - contact_radius(bed, stretch_before[i]));
  }
}

}  // namespace

double crush_work(const Foam& foam, double strain) {
  const int pieces = 4000;
  double work = 0.0, before = 0.0;
  for (int k = 1; k <= pieces; ++k) {
    const double e = strain * k / pieces;
    const double now = std::min(-foam.youngs_modulus * std::log1p(-e), foam.yield_stress(e));
    work += 0.5 * (before + now) * strain / pieces;
    before = now;
  }
  return work;
}

PressResult press(const PressCase& given) {
  const auto begin = std::chrono::steady_clock::now();
  BedSpec spec;
  spec.foam = given.foam, spec.spacing = given.spacing, spec.depth = given.depth, spec.half_width = given.width;
  spec.hold_bottom = false, spec.mirror_ends = true;
  spec.columns = std::max(1, static_cast<int>(std::lround(given.length / given.spacing)));
  spec.alpha = given.alpha, spec.beta = given.beta, spec.cfl = given.cfl, spec.speed = given.speed;
  spec.threads = given.threads;
  Bed bed = make_bed(spec);
  Platen platen;
  platen.height = given.depth;
  platen.stiffness = 2.0 * given.foam.youngs_modulus * given.spacing;
  platen.damping = 0.2 * std::sqrt(platen.stiffness * bed.mass);

  PressResult result;
  std::vector<float> stretch_before;
  const double area = bed.half_width * spec.columns * spec.spacing;
  const double ramp_time = 2.0 * 0.05 * given.depth / given.speed;
  double work = 0.0, direction = 1.0;
  bool turned = false;
  while (true) {
    // Smooth start, and a smooth turn when unloading is asked for.
    const double target = direction * given.speed;
    platen.speed +=
        std::clamp(target - platen.speed, -given.speed * bed.dt / ramp_time, given.speed * bed.dt / ramp_time);
    platen.height -= bed.dt * platen.speed;
    const double strain = 1.0 - platen.height / given.depth;
    if (!turned && strain >= given.strain_end) {
      if (given.unload_to < 0.0) break;
      turned = true, direction = -0.2;
    }
    if (turned && platen.speed < 0.0 && strain <= given.unload_to) break;
    drift(bed);
    stretch_before = bed.particles.stretch;
    apc::sph::strain(bed);
    accelerate(bed);
    push(bed, platen, stretch_before);
    kick(bed);
    work += bed.dt * platen.force * platen.speed;
    if (bed.steps % 20 == 0) {
      result.strain.push_back(strain), result.force.push_back(platen.force), result.work.push_back(work);
      result.work_exact.push_back(area * given.depth * crush_work(given.foam, std::max(0.0, strain)));
    }
  }
  double sum = 0.0;
  int counted = 0;
  for (std::size_t k = 0; k < result.strain.size(); ++k)
    if (result.strain[k] > 0.05 && !turned) sum += std::pow(result.work[k] - result.work_exact[k], 2), ++counted;
  if (counted > 0) result.energy_rmse = std::sqrt(sum / counted) / result.work_exact.back();
  result.internal = bed.energy.internal, result.viscous = bed.energy.viscous + bed.energy.damping;
  result.kinetic = bed.energy.kinetic, result.contact = platen.stored + platen.damped + bed.energy.floor;
  result.radius = platen.radius_work;
  result.residual = (work - result.internal - result.viscous - result.kinetic - result.contact - result.radius) / work;
  result.compaction = inspect(bed).compaction;
  result.particles = bed.alive, result.steps = static_cast<double>(bed.steps);
  result.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  result.particle_steps_per_s = static_cast<double>(bed.particle_steps) / result.wall_s;
  return result;
}

}  // namespace apc::sph
