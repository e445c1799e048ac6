#include "sph_backend/checkpoint_hdf5.h"

#include <cstdio>

#include "apc/base/hdf5.h"
#include "apc/base/require.h"

namespace apc::sph {
namespace {

/// The case as text, every digit: a checkpoint is resumed only by the same case.
std::string fingerprint(const RollingCase& c) {
  std::string text = c.tire.name + "|" + c.foam.name;
  const auto add = [&text](double value) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "|%.17g", value);
    text += buffer;
  };
  for (const double v : {c.tire.diameter,
                         c.tire.width,
                         c.tire.rim_diameter,
                         c.tire.inflation,
                         c.tire.rated_load,
                         c.tire.rated_deflection,
                         c.tire.bottoming_load,
                         c.tire.bottoming_deflection,
                         c.foam.density,
                         c.foam.youngs_modulus,
                         c.foam.poisson_ratio,
                         c.foam.tension_cutoff,
                         c.foam.damping,
                         c.bed_depth,
                         c.penetration,
                         c.speed,
                         c.spacing,
                         c.friction,
                         c.bed_half_width,
                         c.outer_wall ? 1.0 : 0.0,
                         c.hold_bottom ? 1.0 : 0.0,
                         c.ahead,
                         c.behind,
                         c.press_speed,
                         c.accelerate_distance,
                         c.fall,
                         c.release_spin_ratio,
                         c.alpha,
                         c.beta,
                         c.cfl,
                         c.window,
                         c.entry,
                         static_cast<double>(c.spin),
                         static_cast<double>(c.form),
                         c.rigid_roller ? 1.0 : 0.0})
    add(v);
  for (const double v : c.foam.load_curve.x()) add(v);
  for (const double v : c.foam.load_curve.y()) add(v);
  return text;
}

/// Scalars of the run in a fixed order, for both directions.
template <class Run, class Visit>
void for_each_scalar(Run& run, Visit&& visit) {
  auto& b = run.bed;
  auto& e = run.energy;
  auto& s = run.sums;
  visit(b.time), visit(b.energy.internal), visit(b.energy.viscous), visit(b.energy.damping), visit(b.energy.floor);
  visit(b.energy.kinetic), visit(b.energy.removed);
  visit(e.axle_work), visit(e.spin_work), visit(e.friction), visit(e.contact_penalty), visit(e.contact_damping);
  visit(e.contact_radius), visit(e.tire_damping), visit(e.wheel_kinetic);
  visit(s.drag), visit(s.vertical), visit(s.spin), visit(s.deflection), visit(s.steps), visit(s.distance);
  visit(run.tire.angle), visit(run.tire.spin), visit(run.contact.force_x), visit(run.contact.force_z);
}

template <class Run, class Visit>
void for_each_series(Run& run, Visit&& visit) {
  auto& h = run.history;
  visit("time", h.time), visit("distance", h.distance), visit("drag", h.drag), visit("vertical", h.vertical);
  visit("spin_ratio", h.spin_ratio), visit("deflection", h.deflection), visit("internal", run.internal);
  visit("tire_u", run.tire.u), visit("tire_rate", run.tire.rate);
  auto& p = run.bed.particles;
  visit("x", p.x), visit("y", p.y), visit("z", p.z), visit("vx", p.vx), visit("vy", p.vy), visit("vz", p.vz);
}

template <class Run, class Visit>
void for_each_float_field(Run& run, Visit&& visit) {
  auto& p = run.bed.particles;
  visit("stretch", p.stretch), visit("work", p.work);
  const char* names[6] = {"sxx", "syy", "szz", "sxy", "sxz", "syz"};
  for (int c = 0; c < 6; ++c) visit(names[c], p.stress[c]);
  visit("reach", run.bed.neighbours.reach), visit("built_at", run.bed.neighbours.built_at);
}

template <class Run, class Visit>
void for_each_integer_field(Run& run, Visit&& visit) {
  auto& p = run.bed.particles;
  visit("id", p.id), visit("column", p.column), visit("hold", p.hold), visit("layer_hold", p.layer_hold);
  visit("list", run.bed.neighbours.list), visit("first", run.bed.neighbours.first);
}

}  // namespace

void save_checkpoint(const RollingRun& run, const std::filesystem::path& path) {
  save_hdf5(path, [&](Hdf5Writer& file) {
    file.attribute("/", "schema", "apc-sph-checkpoint/2");
    file.attribute("/", "case", fingerprint(run.setup));
    std::vector<double> scalars;
    for_each_scalar(run, [&](double v) { scalars.push_back(v); });
    file.array("scalars", scalars, "1");
    for_each_series(run, [&](const char* name, const std::vector<double>& v) { file.array(name, v, "1"); });
    for_each_float_field(run, [&](const char* name, const std::vector<float>& v) { file.floats(name, v, "1"); });
    for_each_integer_field(run, [&](const char* name, const auto& v) {
      file.integers(name, std::vector<std::int64_t>(v.begin(), v.end()));
    });
    const Bed& b = run.bed;
    file.integers("counters", {b.steps, b.particle_steps, b.rebuilds, b.next_id, b.alive, b.spec.first_column,
                               b.spec.columns, b.neighbours.clusters});
    std::vector<std::int64_t> parent;
    std::vector<float> placement;
    for (const Image& image : b.neighbours.images) {
      parent.push_back(image.parent);
      placement.insert(placement.end(), image.sign, image.sign + 3);
      placement.insert(placement.end(), image.shift, image.shift + 3);
    }
    file.integers("image_parent", parent);
    file.floats("image_placement", placement, "m");
  });
}

void load_checkpoint(RollingRun& run, const std::filesystem::path& path) {
  const Hdf5Reader file(path);
  require(file.has_attribute("/", "schema") && file.text("/", "schema") == "apc-sph-checkpoint/2", path.string(),
          ": is not a checkpoint of an SPH run. Remove it or give another path.");
  require(file.text("/", "case") == fingerprint(run.setup), path.string(),
          ": belongs to another case. Remove it to start anew, or give another checkpoint path.");
  const auto scalars = file.array("scalars").values;
  std::size_t next = 0;
  for_each_scalar(run, [&](double& v) { v = scalars.at(next++); });
  for_each_series(run, [&](const char* name, std::vector<double>& v) { v = file.array(name).values; });
  for_each_float_field(run, [&](const char* name, std::vector<float>& v) { v = file.floats(name); });
  for_each_integer_field(run, [&](const char* name, auto& v) {
    const auto stored = file.integers(name);
    v.assign(stored.begin(), stored.end());
  });
  const auto counters = file.integers("counters");
  Bed& b = run.bed;
  b.steps = counters.at(0), b.particle_steps = counters.at(1), b.rebuilds = counters.at(2);
  b.next_id = static_cast<std::int32_t>(counters.at(3)), b.alive = static_cast<int>(counters.at(4));
  b.spec.first_column = static_cast<int>(counters.at(5)), b.spec.columns = static_cast<int>(counters.at(6));
  Neighbours& n = b.neighbours;
  n.clusters = static_cast<int>(counters.at(7));
  n.grid.origin[0] = b.spec.first_column * b.spec.spacing;
  n.grid.extent[0] = b.spec.columns * b.spec.spacing;
  const auto parent = file.integers("image_parent");
  const auto placement = file.floats("image_placement");
  n.images.assign(parent.size(), Image{});
  for (std::size_t i = 0; i < parent.size(); ++i) {
    n.images[i].parent = static_cast<std::uint32_t>(parent[i]);
    for (int a = 0; a < 3; ++a)
      n.images[i].sign[a] = placement[6 * i + a], n.images[i].shift[a] = placement[6 * i + 3 + a];
  }
  // Records are filled from the particles at the next step; only their room is needed.
  add_records(n, b.particles.size());
  n.internal.assign(n.clusters, 0.0), n.viscous.assign(n.clusters, 0.0), n.damped.assign(n.clusters, 0.0);
  for (auto& a : b.acceleration) a.assign(b.particles.size(), 0.0f);
}

}  // namespace apc::sph
