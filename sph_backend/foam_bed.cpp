#include "sph_backend/foam_bed.h"

#include <algorithm>
#include <cmath>

#include "sph_backend/kernel.h"
#include "sph_backend/pair_kernels.h"

namespace apc::sph {
namespace {

constexpr int piece = 1024;         // particles of one piece of work
constexpr double floor_gap = 0.05;  // in layers: half the height of a particle compacted to 90 %

int layers(const Bed& bed) { return static_cast<int>(std::lround(bed.spec.depth / bed.layer)); }
int rows(const Bed& bed) { return static_cast<int>(std::lround(bed.half_width / bed.spec.spacing)); }

void append_column(Bed& bed, int column) {
  Particles& p = bed.particles;
  std::size_t i = p.size();
  for_each_field(p, [&](auto& field) { field.resize(field.size() + rows(bed) * layers(bed)); });
  for (int j = 0; j < rows(bed); ++j)
    for (int k = 0; k < layers(bed); ++k, ++i) {
      p.x[i] = column_position(bed.spec, column);
      p.y[i] = (j + 0.5) * bed.spec.spacing;
      p.z[i] = (k + 0.5) * bed.layer;
      p.stretch[i] = 1.0f;
      p.id[i] = bed.next_id++;
      p.column[i] = column;
      p.layer_hold[i] = bed.spec.hold_bottom && !bed.spec.free_body && k == 0 ? hold_x | hold_y : free_to_move;
    }
}

void fill_records(Bed& bed, int first, int last) {
  using namespace record;
  const Particles& p = bed.particles;
  Neighbours& n = bed.neighbours;
  const double h0 = smoothing_ratio * bed.spec.spacing;
  const float quarter = static_cast<float>(0.25 / h0), most = static_cast<float>(1.0 / smoothing_floor);
  // For a pair's μ doubled, as the kernel takes it: ½ of α c̄/ρ̄ and ¼ of β/ρ̄, and half of either from each partner.
  const float a0 =
      static_cast<float>(0.25 * bed.mass * bed.spec.alpha * bed.spec.foam.sound_speed() / bed.spec.foam.density);
  const float b0 = static_cast<float>(0.125 * bed.mass * bed.spec.beta / bed.spec.foam.density);
  const float v0 = static_cast<float>(bed.volume0);
  for (int i = first; i < last; ++i) {
    float* r = &n.records[static_cast<std::size_t>(i) * record::size];
    const float s = p.stretch[i], ratio = 1.0f / (s * s * s);
    r[x] = static_cast<float>(p.x[i] - n.grid.origin[0]);
    r[y] = static_cast<float>(p.y[i] - n.grid.origin[1]);
    r[z] = static_cast<float>(p.z[i] - n.grid.origin[2]);
    r[vx] = static_cast<float>(p.vx[i]), r[vy] = static_cast<float>(p.vy[i]), r[vz] = static_cast<float>(p.vz[i]);
    r[quarter_inverse_h] = quarter * std::min(std::max(s, 1.0f), most);
    r[visc_a] = a0 * ratio * std::sqrt(ratio);
    r[visc_b] = b0 * ratio;
    r[volume] = v0 * ratio;
  }
}

void fill_stress_records(Bed& bed, int first, int last) {
  const Particles& p = bed.particles;
  for (int i = first; i < last; ++i) {
    const float s = p.stretch[i], v = static_cast<float>(bed.volume0) / (s * s * s);
    const float scale = bed.spec.form == PairForm::mass ? v * v : 1.0f;
    for (int c = 0; c < 6; ++c)
      bed.neighbours.records[static_cast<std::size_t>(i) * record::size + record::sxx + c] =
          p.stress[c][i] * (scale / static_cast<float>(bed.mass));
  }
}

/// Volumes of this step for the volume form, once no strain rate needs those of the last one any more.
void fill_volume_records(Bed& bed) {
  const Particles& p = bed.particles;
  bed.team->run(static_cast<int>(p.size()), piece, [&](int first, int last) {
    for (int i = first; i < last; ++i) {
      const float s = p.stretch[i];
      bed.neighbours.records[static_cast<std::size_t>(i) * record::size + record::volume] =
          static_cast<float>(bed.volume0) / (s * s * s);
    }
  });
}

void renew_neighbours(Bed& bed) {
  Neighbours& n = bed.neighbours;
  n.grid.origin[0] = bed.spec.first_column * bed.spec.spacing;
  const double rear = bed.spec.mirror_ends || bed.spec.free_body ? -1e30 : n.grid.origin[0];
  bed.alive = sort_particles(bed.particles, n, rear, *bed.team);
  n.records.resize(bed.particles.size() * record::size);
  bed.team->run(static_cast<int>(bed.particles.size()), piece, [&](int first, int last) {
    fill_records(bed, first, last);
    fill_stress_records(bed, first, last);
  });
  build_lists(n, bed.particles, *bed.team);
  for (auto& a : bed.acceleration) a.resize(bed.particles.size());
  ++bed.rebuilds;
}

PairWork pair_work(Bed& bed) {
  Particles& p = bed.particles;
  Neighbours& n = bed.neighbours;
  const Foam& foam = bed.spec.foam;
  PairWork w{};
  w.records = n.records.data(), w.neighbour = n.list.data(), w.first = n.first.data();
  w.stretch = p.stretch.data(), w.work = p.work.data();
  for (int c = 0; c < 6; ++c) w.stress[c] = p.stress[c].data();
  for (int a = 0; a < 3; ++a) w.acceleration[a] = bed.acceleration[a].data();
  w.internal = n.internal.data(), w.viscous = n.viscous.data(), w.damped = n.damped.data();
  w.yield = bed.yield.stress.data(), w.yield_intervals = YieldTable::intervals, w.yield_lowest = bed.yield.lowest;
  w.form = bed.spec.form;
  w.tension_cutoff = static_cast<float>(foam.tension_cutoff);
  w.dt = static_cast<float>(bed.dt);
  w.lame_lambda = static_cast<float>(foam.lame_lambda()), w.shear_modulus = static_cast<float>(foam.shear_modulus());
  w.poisson_ratio = static_cast<float>(foam.poisson_ratio);
  w.volume0 = static_cast<float>(bed.volume0), w.mass = static_cast<float>(bed.mass);
  w.damping = static_cast<float>(foam.sound_speed() * foam.density * foam.damping * bed.spec.spacing);
  return w;
}

/// The mirror plane carries the foam; this catches what is squeezed towards it beyond any lawful compaction. Returns
/// the energy stored.
double push_off_floor(Bed& bed) {
  const Particles& p = bed.particles;
  const double k = 6.0 * bed.spec.foam.youngs_modulus * bed.spec.spacing;
  return bed.team->sum(static_cast<int>(p.size()), piece, [&](int first, int last) {
    double stored = 0.0;
    for (int i = first; i < last; ++i) {
      const double overlap = floor_gap * bed.layer - p.z[i];
      if (overlap <= 0.0) continue;
      bed.acceleration[2][i] += static_cast<float>(k * overlap / bed.mass);
      if (p.hold[i] != hold_all) stored += 0.5 * k * overlap * overlap;
    }
    return stored;
  });
}

double total(const std::vector<double>& parts) {
  double sum = 0.0;
  for (const double part : parts) sum += part;
  return sum;
}

}  // namespace

Bed make_bed(const BedSpec& spec) {
  Bed bed;
  bed.spec = spec;
  bed.team = std::make_shared<Team>(spec.threads);
  bed.layer = spec.depth / std::max(1.0, std::round(spec.depth / spec.spacing));
  bed.half_width = spec.spacing * std::max(1.0, std::round(spec.half_width / spec.spacing));
  bed.volume0 = spec.spacing * spec.spacing * bed.layer;
  bed.mass = spec.foam.density * bed.volume0;
  bed.yield = tabulate(spec.foam);
  const double h0 = smoothing_ratio * spec.spacing;
  bed.dt = spec.cfl * h0 / (spec.foam.sound_speed() + spec.speed);

  NeighbourGrid& grid = bed.neighbours.grid;
  grid.spacing = spec.spacing, grid.support = 2.0 * h0, grid.dt = bed.dt;
  grid.extent[0] = spec.columns * spec.spacing, grid.extent[1] = bed.half_width;
  if (!spec.free_body) grid.planes.push_back({1, 0.0, +1});
  if (spec.outer_wall && !spec.free_body) grid.planes.push_back({1, bed.half_width, -1});
  if (spec.mirror_ends && !spec.free_body) {
    grid.planes.push_back({0, spec.first_column * spec.spacing, +1});
    grid.planes.push_back({0, (spec.first_column + spec.columns) * spec.spacing, -1});
  }
  if (!spec.free_body) grid.planes.push_back({2, 0.0, +1});

  for (int c = 0; c < spec.columns; ++c) append_column(bed, spec.first_column + c);
  move_window(bed, spec.first_column, spec.first_column + spec.columns);
  return bed;
}

void shorten_step(Bed& bed, double longest) {
  bed.dt = std::min(bed.dt, longest);
  bed.neighbours.grid.dt = bed.dt;
}

void move_window(Bed& bed, int first_column, int end_column) {
  Particles& p = bed.particles;
  for (int c = bed.spec.first_column + bed.spec.columns; c < end_column; ++c) append_column(bed, c);
  bed.spec.first_column = first_column, bed.spec.columns = end_column - first_column;
  bed.neighbours.grid.extent[0] = bed.spec.columns * bed.spec.spacing;
  const double rear =
      (first_column + bed.spec.held_columns) * bed.spec.spacing;  // by place: a plough carries foam along
  const int first_ahead = end_column - bed.spec.held_columns;
  bed.energy.removed += bed.team->sum(static_cast<int>(p.size()), piece, [&](int first, int last) {
    double removed = 0.0;
    for (int i = first; i < last; ++i) {
      if (p.id[i] < 0) continue;
      const bool held = !bed.spec.mirror_ends && !bed.spec.free_body && (p.x[i] < rear || p.column[i] >= first_ahead);
      if (held) {
        removed += 0.5 * bed.mass * (p.vx[i] * p.vx[i] + p.vy[i] * p.vy[i] + p.vz[i] * p.vz[i]);
        p.vx[i] = p.vy[i] = p.vz[i] = 0.0;
      }
      p.hold[i] = held ? std::uint8_t{hold_all} : p.layer_hold[i];
    }
    return removed;
  });
  renew_neighbours(bed);
}

void drift(Bed& bed) {
  Particles& p = bed.particles;
  Neighbours& n = bed.neighbours;
  const int count = static_cast<int>(p.size());
  std::atomic<bool> outrun{false};
  bed.team->run(count, piece, [&](int first, int last) {
    bool far = false;
    for (int i = first; i < last; ++i)
      p.x[i] += bed.dt * p.vx[i], p.y[i] += bed.dt * p.vy[i], p.z[i] += bed.dt * p.vz[i];
    fill_records(bed, first, last);
    for (int i = first; i < last; ++i) {
      const float* r = &n.records[static_cast<std::size_t>(i) * record::size];
      const float dx = r[0] - n.built_at[3 * i], dy = r[1] - n.built_at[3 * i + 1], dz = r[2] - n.built_at[3 * i + 2];
      far |= dx * dx + dy * dy + dz * dz > n.reach[i] * n.reach[i];
    }
    if (far) outrun = true;
  });
  bed.time += bed.dt;
  ++bed.steps;
  bed.particle_steps += bed.alive;
  if (outrun)
    renew_neighbours(bed);
  else
    refresh_motion(n.records, p.size(), n.images, *bed.team);
}

void strain(Bed& bed) {
  const PairWork work = pair_work(bed);
  const auto& kernels = pair_kernels();
  bed.team->run(bed.neighbours.clusters, 8, [&](int first, int last) { kernels.strain(work, first, last); });
  if (bed.spec.form == PairForm::volume) fill_volume_records(bed);
  refresh_stress(bed.neighbours.records, bed.particles.size(), bed.neighbours.images, *bed.team);
  bed.energy.internal += total(bed.neighbours.internal);
  bed.energy.damping += total(bed.neighbours.damped);
}

void accelerate(Bed& bed) {
  const PairWork work = pair_work(bed);
  const auto& kernels = pair_kernels();
  bed.team->run(bed.neighbours.clusters, 8, [&](int first, int last) { kernels.accelerate(work, first, last); });
  bed.energy.viscous += total(bed.neighbours.viscous);
  if (!bed.spec.free_body) bed.energy.floor = push_off_floor(bed);
}

void kick(Bed& bed) {
  Particles& p = bed.particles;
  const double twice = bed.team->sum(static_cast<int>(p.size()), piece, [&](int first, int last) {
    double sum = 0.0;
    for (int i = first; i < last; ++i) {
      if (p.hold[i] == hold_all) continue;
      if (!(p.hold[i] & hold_x)) p.vx[i] += bed.dt * bed.acceleration[0][i];
      if (!(p.hold[i] & hold_y)) p.vy[i] += bed.dt * bed.acceleration[1][i];
      if (!(p.hold[i] & hold_z)) p.vz[i] += bed.dt * bed.acceleration[2][i];
      sum += p.vx[i] * p.vx[i] + p.vy[i] * p.vy[i] + p.vz[i] * p.vz[i];
    }
    return sum;
  });
  bed.energy.kinetic = 0.5 * bed.mass * twice;
}

double largest_compaction(const Bed& bed) {
  double stretch = 1.0;
  for (const float one : bed.particles.stretch) {
    if (std::isnan(one)) return one;
    stretch = std::max(stretch, static_cast<double>(one));
  }
  return 1.0 - 1.0 / (stretch * stretch * stretch);
}

BedState inspect(const Bed& bed) {
  const Neighbours& n = bed.neighbours;
  BedState state;
  state.compaction = largest_compaction(bed);
  state.partition_min = 1.0;
  double sum = 0.0;
  int counted = 0;
  for (int c = 0; c < n.clusters; ++c)
    for (int i = c * lanes; i < (c + 1) * lanes; ++i) {
      if (bed.particles.id[i] < 0) continue;
      const double s = bed.particles.stretch[i], compaction = 1.0 - 1.0 / (s * s * s);
      if (compaction < 0.5) continue;
      const float* r = &n.records[static_cast<std::size_t>(i) * record::size];
      double partition = 0.0;
      for (std::uint32_t k = n.first[c]; k < n.first[c + 1]; ++k) {
        const float* q = &n.records[static_cast<std::size_t>(n.list[k]) * record::size];
        const double g = 2.0 * (r[record::quarter_inverse_h] + q[record::quarter_inverse_h]);
        partition += q[record::volume] * kernel(std::hypot(r[0] - q[0], r[1] - q[1], r[2] - q[2]), g);
      }
      state.partition_min = std::min(state.partition_min, partition);
      sum += partition, ++counted;
    }
  state.partition_mean = counted > 0 ? sum / counted : 1.0;
  double bytes = 0.0;
  for_each_field(bed.particles, [&](const auto& field) { bytes += sizeof(field[0]) * field.size(); });
  bytes += sizeof(float) * (n.records.size() + n.reach.size() + n.built_at.size() + 3.0 * bed.acceleration[0].size());
  bytes += sizeof(Image) * n.images.size() + sizeof(std::uint32_t) * (n.list.size() + n.first.size());
  const RenewalRoom& room = n.room;
  bytes += sizeof(CellEntry) * (room.entries.size() + room.sorted.size()) + 6 * sizeof(float) * room.number.size();
  bytes += sizeof(double) * room.doubles.size() + sizeof(float) * (room.floats.size() + room.integers.size());
  bytes += room.bytes.size() + sizeof(std::uint32_t) * room.order.size();
  for (const auto& list : room.lists) bytes += sizeof(std::uint32_t) * list.size();
  state.bytes_per_particle = bytes / std::max(1, bed.alive);
  return state;
}

StepCount count_step(const Bed& given) {
  Bed bed = given;
  drift(bed);
  const PairWork work = pair_work(bed);
  const Neighbours& n = bed.neighbours;
  take_operations();
  kernels_counted().strain(work, 0, n.clusters);
  refresh_stress(bed.neighbours.records, bed.particles.size(), n.images, *bed.team);
  kernels_counted().accelerate(work, 0, n.clusters);

  StepCount count;
  const double particles = std::max(1, bed.alive), entries = static_cast<double>(n.list.size());
  count.operations = static_cast<double>(take_operations()) / particles;
  count.pairs = entries * lanes / particles;
  for (int c = 0; c < n.clusters; ++c)
    for (int i = c * lanes; i < (c + 1) * lanes; ++i) {
      if (bed.particles.id[i] < 0) continue;
      const float* r = &n.records[static_cast<std::size_t>(i) * record::size];
      for (std::uint32_t k = n.first[c]; k < n.first[c + 1]; ++k) {
        const float* q = &n.records[static_cast<std::size_t>(n.list[k]) * record::size];
        const double u = r[record::quarter_inverse_h] + q[record::quarter_inverse_h];
        count.pairs_within += std::hypot(r[0] - q[0], r[1] - q[1], r[2] - q[2]) * u < 1.0 ? 1.0 / particles : 0.0;
      }
    }
  constexpr double line = record::size * sizeof(float), number = sizeof(std::uint32_t);
  count.neighbour_bytes = 2.0 * entries * (line + number) / particles;  // in either sum
  // Drift: position and velocity, and the record with its 10 fields of motion. Law: stretch, stress and work, read and
  // written, and 6 fields of the record. Both sums: the record. Accelerations out and in. Kick: velocity, twice.
  count.own_bytes = 9 * sizeof(double) + 15 * sizeof(float) + (16 + 6) * sizeof(float) + 2 * line + 6 * sizeof(float) +
                    6 * sizeof(double);
  return count;
}

}  // namespace apc::sph
