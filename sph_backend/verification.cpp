#include "sph_backend/verification.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "apc/base/require.h"
#include "apc/base/units.h"
#include "sph_backend/fem/fem_rig.h"
#include "sph_backend/press_rig.h"
#include "sph_backend/rolling_history.h"

namespace apc::sph {
namespace {

using namespace units;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

Quantity quantity(const Verification& v, const char* name, const char* unit, double value) {
  return {name, unit, value, published(v.study, v.method, name).extrapolated,
          published(v.study, Method::fem, name).extrapolated};
}

Foam foam_of(const StudyOptions& options) {
  Foam foam = ideal_foam_50psi();
  if (options.tension_cutoff >= 0.0) foam.tension_cutoff = options.tension_cutoff;
  return foam;
}

void verify_press(Verification& v, const StudyOptions& options) {
  const bool punch = v.study == Study::punch_2d;
  PressCase c;
  c.foam = foam_of(options);
  c.width = c.length = 12.0 * in, c.depth = 24.0 * in, c.spacing = v.spacing;
  c.alpha = options.alpha, c.cfl = options.cfl, c.form = options.form, c.threads = options.threads;
  if (punch) {
    c.punch_half_width = 8.25 * in, c.width = 24.0 * in, c.strain_end = 16.0 / 24.0;
    c.length = v.method == Method::fem ? v.spacing : 4.0 * v.spacing;  // plane strain: a slab as thin as may be
  }
  const PressResult r = v.method == Method::fem ? fem::press(c, options.elements) : press(c);
  v.symmetry = punch ? "unit width" : "full", v.state = r.inverted ? "unstable" : "done";
  if (r.inverted) v.message = concat("elements turned inside out at a strain of ", r.strain.back());
  const double work = r.work.back();
  if (punch) {
    const double plateau = c.foam.yield_stress(0.0) * c.punch_half_width * c.strain_end * c.depth;
    v.quantities.push_back({"work_ratio", "1", work / c.length / plateau, none, none});
    v.assumptions = {"block of 24 in half-width", "frictionless face and flanks", "pressed at 100 in/s"};
  } else {
    v.quantities.push_back(quantity(v, "energy_rmse", "1", r.energy_rmse));
    v.quantities.push_back({"absorbed_energy", "J", work, r.work_exact.back(), r.work_exact.back()});
    v.assumptions = {"pressed at 100 in/s after a smooth start over 5 % of strain",
                     "RMS over strains from 5 to 85 %, relative to the exact work at 85 %"};
  }
  if (options.form == PairForm::volume) v.assumptions.push_back("volume form of the pair sums");
  v.energy = {{"foam, internal", r.internal / work},
              {"foam, kinetic", r.kinetic / work},
              {"artificial viscosity", r.viscous / work},
              {"foam damping", r.damping / work},
              {"contact, stored and damped", r.contact / work},
              {"contact radius", r.radius / work}};
  if (v.method == Method::fem) v.energy.push_back({"hourglass control", r.hourglass / work});
  v.hourglass_share = r.hourglass / r.internal;
  v.energy_residual = r.residual, v.viscous_share = r.viscous / work, v.compaction = r.compaction,
  v.partition = r.partition;
  v.bytes_per_particle = r.bytes_per_particle;
  v.particles = r.particles, v.steps = r.steps, v.particle_steps_per_s = r.particle_steps_per_s, v.wall_s = r.wall_s;
}

RollingCase published_case(const Verification& v, const StudyOptions& options) {
  RollingCase c;
  if (v.study == Study::deck) {
    c = options.deck;
    c.spacing = v.spacing, c.load_tolerance = 0.01, c.spin_tolerance = 0.005;
    if (options.friction >= 0.0) c.friction = options.friction;
    c.form = options.form;
    return c;
  }
  c.foam = foam_of(options);
  c.tire = {"H44.5x16.5-21", 44.5 * in, 16.5 * in,   21.0 * in, 214.0 * psi,
            44700.0 * lbf,   3.5 * in,  121e3 * lbf, 8.5 * in};
  c.bed_depth = 24.0 * in, c.penetration = 16.0 * in, c.speed = 1418.0 * in, c.spacing = v.spacing;
  c.alpha = options.alpha, c.cfl = options.cfl, c.form = options.form;
  c.load_tolerance = 0.01, c.spin_tolerance = 0.005;
  c.rigid_roller = v.study == Study::roller_2d;
  c.friction = options.friction >= 0.0 ? options.friction : c.rigid_roller ? 0.0 : 0.3;
  c.spin = options.spin, c.entry = options.entry, c.outer_wall = options.outer_wall || c.rigid_roller;
  c.hold_bottom = options.hold_bottom;
  c.bed_half_width = !c.rigid_roller ? 12.0 * in : v.method == Method::fem ? v.spacing : 4.0 * v.spacing;
  return c;
}

std::vector<std::string> assumptions_of(const RollingCase& c) {
  const double radius = 0.5 * c.tire.diameter;
  std::vector<std::string> out{
      concat("friction ", c.friction),
      c.spin == WheelSpin::free     ? "free-spinning"
      : c.spin == WheelSpin::driven ? "spin held at v/R"
                                    : "locked wheel",
      c.entry > 0.0 ? concat("rolled in at full speed over ", c.entry / in, " in")
                    : std::string("pressed in at rest, then accelerated"),
      concat("means over two windows of ", radius / in, " in after settling within ", 100 * c.load_tolerance, " %"),
      concat("tension cutoff ", c.foam.tension_cutoff / psi, " psi"),
      c.hold_bottom ? "lowest layer held" : "floor that slips",
      c.rigid_roller ? "plane strain"
      : c.outer_wall ? "mirror plane outside"
                     : "free outer face"};
  if (c.form == PairForm::volume) out.push_back("volume form of the pair sums");
  return out;
}

/// Loads of the modelled part: the roller's per width, the tire's of the modelled half.
double modelled_share(const RollingCase& c) { return c.rigid_roller ? 0.5 / c.bed_half_width : 0.5; }

void set_loads(Verification& v, double drag, double vertical, double internal) {
  const bool roller = v.study == Study::roller_2d;
  v.quantities = {quantity(v, "vertical", roller ? "N/m" : "N", vertical),
                  quantity(v, "drag", roller ? "N/m" : "N", drag),
                  quantity(v, "internal_energy_rate", roller ? "J/m^2" : "J/m", internal)};
  if (v.method == Method::fem) v.quantities.push_back(quantity(v, "hourglass_share", "1", v.hourglass_share));
}

RollingResult roll_case(const RollingCase& c, const Verification& v, const StudyOptions& options) {
  RollOptions roll_options;
  roll_options.threads = options.threads, roll_options.progress = options.progress, roll_options.stop = options.stop;
  if (v.method == Method::fem) return fem::roll(c, options.elements, roll_options);
  if (!options.checkpoint.empty())
    roll_options.checkpoint = options.checkpoint / concat(name_of(v.study), "_", std::lround(v.spacing * 1e6), ".h5");
  return roll(c, roll_options);
}

RollingResult verify_rolling(Verification& v, const StudyOptions& options) {
  const RollingCase c = published_case(v, options);
  const RollingResult r = roll_case(c, v, options);
  const double share = modelled_share(c), input = r.energy.input();
  v.symmetry = c.rigid_roller ? "unit width" : "half", v.state = name_of(r.state), v.message = r.message;
  v.hourglass_share = r.energy.hourglass / r.energy.foam_internal;
  set_loads(v, share * r.drag, share * r.vertical, share * r.internal_energy_rate);
  v.assumptions = assumptions_of(c);
  for (const EnergyTerm& term : energy_out(r.energy)) v.energy.push_back({term.name, term.value / input});
  v.energy_residual = r.residual, v.viscous_share = r.energy.viscosity / input;
  v.spin_ratio = r.spin_ratio, v.rut_depth = r.rut_depth, v.compaction = r.compaction, v.partition = r.partition_mean;
  v.particles = r.particles, v.steps = r.steps, v.particle_steps_per_s = r.particle_steps_per_s, v.wall_s = r.wall_s;
  v.bytes_per_particle = r.bytes_per_particle, v.shape = r.shape;
  v.travel = r.history.distance.empty() ? 0.0 : r.history.distance.back();
  return r;
}

/// Mean of drag and vertical over bins [first, first + count) of a history.
std::array<double, 2> mean_loads(const RollingHistory& h, std::size_t first, std::size_t count) {
  std::array<double, 2> mean{};
  for (std::size_t b = first; b < first + count; ++b) mean[0] += h.drag[b], mean[1] += h.vertical[b];
  for (double& m : mean) m /= static_cast<double>(count);
  return mean;
}

/// Where the averaging window lies: the lowest and highest mean over two radii in one long run, and the mean over the
/// whole bed of 200 in with a ramped entry in it.
void add_window_rows(Study study, double spacing, const StudyOptions& options, std::vector<SpanRow>& rows) {
  Verification row;
  row.study = study, row.method = options.method, row.spacing = spacing, row.state = "window";
  RollingCase c = published_case(row, options);
  c.load_tolerance = 0.0;
  const double share = modelled_share(c);
  const RollingResult all = roll_case(c, row, options);
  row.energy_residual = all.residual;
  const std::size_t bins = 2 * bins_per_window;
  std::array<double, 2> low{1e300, 1e300}, high{};
  for (std::size_t k = bins; k + bins <= all.history.drag.size(); ++k) {  // the first two windows belong to the start
    const auto mean = mean_loads(all.history, k, bins);
    for (int q = 0; q < 2; ++q) low[q] = std::min(low[q], mean[q]), high[q] = std::max(high[q], mean[q]);
  }
  set_loads(row, share * low[0], share * low[1], none);
  rows.push_back({"lowest mean over 2 R in ten radii of travel", row});
  set_loads(row, share * high[0], share * high[1], none);
  rows.push_back({"highest mean over 2 R in ten radii of travel", row});

  c.entry = 50.0 * in, c.longest = 150.0 * in;
  const RollingResult way = roll_case(c, row, options);
  if (way.history.drag.empty()) return;
  const auto mean = mean_loads(way.history, 0, way.history.drag.size());
  set_loads(row, share * mean[0], share * mean[1],
            2.0 * share * way.energy.foam_internal / way.history.distance.back());
  row.energy_residual = way.residual;
  rows.push_back({"mean over 200 in, entry over 50 in included", row});
}

}  // namespace

Study study_of(const std::string& name) {
  for (const Study s : {Study::platen_1d, Study::roller_2d, Study::tire_3d, Study::punch_2d})
    if (name == name_of(s)) return s;
  throw InputError(concat("case ", name, ": unknown. Choose platen_1d, roller_2d, tire_3d or punch_2d."));
}

const char* name_of(Study study) {
  switch (study) {
    case Study::platen_1d:
      return "platen_1d";
    case Study::roller_2d:
      return "roller_2d";
    case Study::tire_3d:
      return "tire_3d";
    case Study::punch_2d:
      return "punch_2d";
    default:
      return "deck";
  }
}

const char* name_of(Method method) { return method == Method::fem ? "fem" : "sph"; }

std::vector<double> published_sizes(Study study) {
  return study == Study::tire_3d ? std::vector{3.0 * in, 2.0 * in, 1.0 * in}
                                 : std::vector{4.0 * in, 2.0 * in, 1.0 * in};
}

Verification verify(Study study, double spacing, const StudyOptions& options) {
  require(spacing > 0.0 && spacing <= 6.0 * in, "particle size ", spacing / in, " in: must lie between 0 and 6 in.");
  Verification v;
  v.study = study, v.method = options.method, v.spacing = spacing;
  if (study == Study::platen_1d || study == Study::punch_2d)
    verify_press(v, options);
  else
    verify_rolling(v, options);
  return v;
}

std::vector<SpanRow> span(Study study, double spacing, const StudyOptions& options) {
  std::vector<SpanRow> rows;
  const auto add = [&](const std::string& what, const StudyOptions& varied) {
    rows.push_back({what, verify(study, spacing, varied)});
  };
  const auto with = [&](auto change) {
    StudyOptions varied = options;
    change(varied);
    return varied;
  };
  add("as stated", options);
  add("viscosity alpha 0.05 instead of 0.1", with([](auto& o) { o.alpha = 0.05; }));
  for (const double cutoff : {1.0, 50.0})
    add(concat("tension cutoff ", cutoff, " psi"), with([&](auto& o) { o.tension_cutoff = cutoff * psi; }));
  if (study == Study::platen_1d || study == Study::punch_2d) return rows;

  for (const double friction : {0.0, 0.3, 0.6})
    add(concat("free, friction ", friction), with([&](auto& o) { o.friction = friction; }));
  add("driven at v/R, friction 0.3", with([](auto& o) { o.spin = WheelSpin::driven, o.friction = 0.3; }));
  add("locked, friction 0.3", with([](auto& o) { o.spin = WheelSpin::locked, o.friction = 0.3; }));
  add("rolled in over 50 in", with([](auto& o) { o.entry = 50.0 * in; }));
  add("floor that slips", with([](auto& o) { o.hold_bottom = false; }));
  if (study == Study::tire_3d) add("free outer face", with([](auto& o) { o.outer_wall = false; }));

  add_window_rows(study, spacing, options, rows);
  return rows;
}

Convergence converge(Study study, const std::vector<double>& sizes, const StudyOptions& options) {
  require(sizes.size() >= 3, "a convergence study needs at least three sizes, got ", sizes.size(), ".");
  Convergence c;
  c.study = study, c.method = options.method, c.sizes = sizes;
  // Halving the size makes eight times the particles and twice the steps.
  const auto work = [](double size) { return std::pow(size, -4.0); };
  double whole = 0.0, done = 0.0;
  for (const double size : sizes) whole += work(size);
  for (const double size : sizes) {
    StudyOptions one = options;
    const std::string at = concat(size / in, " in, ");
    if (options.progress)
      one.progress = [&](double share, const std::string& remark) {
        options.progress((done + share * work(size)) / whole, at + remark);
      };
    c.runs.push_back(verify(study, size, one));
    done += work(size);
  }

  // Places of the three sizes whose index is given: the published ones, or the finest three.
  std::vector<std::size_t> order(sizes.size()), three;
  for (std::size_t k = 0; k < sizes.size(); ++k) order[k] = k;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return sizes[a] < sizes[b]; });
  for (const double wanted : published_sizes(study))
    for (std::size_t k = 0; k < sizes.size(); ++k)
      if (std::abs(sizes[k] / wanted - 1.0) < 1e-6) three.push_back(k);
  if (three.size() != 3) three.assign(order.begin(), order.begin() + 3);

  for (std::size_t q = 0; q < c.runs.front().quantities.size(); ++q) {
    QuantityConvergence qc;
    for (const auto& run : c.runs) qc.values.push_back(run.quantities[q].value);
    qc.finest = c.runs[order.front()].quantities[q];
    qc.fit = fit_power(sizes, qc.values);
    qc.gci = grid_convergence({sizes[three[0]], sizes[three[1]], sizes[three[2]]},
                              {qc.values[three[0]], qc.values[three[1]], qc.values[three[2]]});
    if (qc.fit.valid)
      for (const double value : qc.values)
        qc.errors.push_back(std::abs(value - qc.fit.extrapolated) / std::max(std::abs(qc.fit.extrapolated), 1e-300));
    qc.paper = published(study, options.method, qc.finest.name);
    c.quantities.push_back(qc);
  }
  return c;
}

}  // namespace apc::sph
