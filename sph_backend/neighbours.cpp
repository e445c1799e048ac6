#include "sph_backend/neighbours.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sph_backend/pair_kernels.h"
#include "sph_backend/team.h"

namespace apc::sph {
namespace {

constexpr double cell_spacings = 2.0;
constexpr float far_away = 1e4f;

/// Cells of the plan view; whatever lies outside belongs to the nearest cell.
struct Cells {
  float low_x, low_y, inverse;
  int nx, ny;

  explicit Cells(const NeighbourGrid& grid) {
    const double size = cell_spacings * grid.spacing, margin = 2.0 * size;
    low_x = static_cast<float>(-margin), low_y = static_cast<float>(-margin);
    inverse = static_cast<float>(1.0 / size);
    nx = static_cast<int>(std::ceil((grid.extent[0] + 2.0 * margin) / size));
    ny = static_cast<int>(std::ceil((grid.extent[1] + 2.0 * margin) / size));
  }
  int column(float x) const { return std::clamp(static_cast<int>(std::floor((x - low_x) * inverse)), 0, nx - 1); }
  int row(float y) const { return std::clamp(static_cast<int>(std::floor((y - low_y) * inverse)), 0, ny - 1); }
  int cell(float x, float y) const { return column(x) * ny + row(y); }
  int count() const { return nx * ny; }
};

struct Entry {
  int cell;
  float z;
  std::uint32_t index;
};

/// Stable in the order of `entries` for equal heights, so the result depends on nothing but the state.
void sort_entries(std::vector<Entry>& entries, std::vector<std::uint32_t>& cell_first, int cells) {
  cell_first.assign(cells + 1, 0);
  for (const auto& e : entries) ++cell_first[e.cell + 1];
  std::partial_sum(cell_first.begin(), cell_first.end(), cell_first.begin());
  std::vector<Entry> sorted(entries.size());
  std::vector<std::uint32_t> place(cell_first.begin(), cell_first.end() - 1);
  for (const auto& e : entries) sorted[place[e.cell]++] = e;
  for (int c = 0; c < cells; ++c)
    std::stable_sort(sorted.begin() + cell_first[c], sorted.begin() + cell_first[c + 1],
                     [](const Entry& a, const Entry& b) { return a.z < b.z; });
  entries.swap(sorted);
}

}  // namespace

void sort_particles(Particles& particles, const NeighbourGrid& grid, double rear) {
  const Cells cells(grid);
  std::vector<Entry> entries;
  entries.reserve(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.id[i] < 0 || particles.x[i] < rear) continue;
    entries.push_back({cells.cell(static_cast<float>(particles.x[i] - grid.origin[0]),
                                  static_cast<float>(particles.y[i] - grid.origin[1])),
                       static_cast<float>(particles.z[i] - grid.origin[2]), static_cast<std::uint32_t>(i)});
  }
  std::vector<std::uint32_t> cell_first;
  sort_entries(entries, cell_first, cells.count());

  constexpr std::uint32_t empty = 0xffffffffu;
  std::vector<std::uint32_t> order;
  order.reserve(entries.size() + entries.size() / 4);
  for (int c = 0; c < cells.count(); ++c) {
    for (std::uint32_t k = cell_first[c]; k < cell_first[c + 1]; ++k) order.push_back(entries[k].index);
    while (order.size() % lanes != 0) order.push_back(empty);
  }
  for_each_field(particles, [&](auto& field) {
    using Value = typename std::decay_t<decltype(field)>::value_type;
    std::vector<Value> sorted(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) sorted[i] = order[i] == empty ? Value{} : field[order[i]];
    field.swap(sorted);
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (order[i] != empty) continue;
    particles.id[i] = -1, particles.stretch[i] = 1.0f;
    particles.hold[i] = hold_all;
    particles.x[i] = particles.y[i] = particles.z[i] = far_away;
  }
}

void build_lists(Neighbours& n, const Particles& particles, Team& team) {
  const Cells cells(n.grid);
  const std::size_t count = particles.size();
  n.clusters = static_cast<int>(count / lanes);

  // How far each particle may travel before the list is renewed: some steps at its present speed and a little more.
  const float spacing = static_cast<float>(n.grid.spacing), dt = static_cast<float>(n.grid.dt);
  n.reach.assign(count, 0.0f), n.built_at.resize(3 * count);
  float longest = 0.0f;
  for (std::size_t i = 0; i < count; ++i) {
    const float* r = &n.records[i * record::size];
    const float speed =
        std::sqrt(r[record::vx] * r[record::vx] + r[record::vy] * r[record::vy] + r[record::vz] * r[record::vz]);
    n.reach[i] = std::min(0.03f * spacing + 9.0f * dt * speed, 0.6f * spacing);
    if (particles.hold[i] == hold_all) n.reach[i] = 0.0f;
    longest = std::max(longest, n.reach[i]);
    for (int a = 0; a < 3; ++a) n.built_at[3 * i + a] = r[record::x + a];
  }
  const float range = static_cast<float>(n.grid.support) + 2.0f * longest;
  n.images = make_images(n.records, particles.id, count, n.grid.planes, n.grid.origin, range);
  n.records.resize((count + n.images.size()) * record::size);
  refresh_motion(n.records, count, n.images);
  refresh_stress(n.records, count, n.images);
  for (const auto& image : n.images) n.reach.push_back(n.reach[image.parent]);

  std::vector<Entry> entries;
  entries.reserve(count + n.images.size());
  for (std::size_t i = 0; i < count + n.images.size(); ++i) {
    if (i < count && particles.id[i] < 0) continue;
    const float* r = &n.records[i * record::size];
    entries.push_back({cells.cell(r[record::x], r[record::y]), r[record::z], static_cast<std::uint32_t>(i)});
  }
  std::vector<std::uint32_t> cell_first;
  sort_entries(entries, cell_first, cells.count());

  std::vector<std::vector<std::uint32_t>> lists(n.clusters);
  const auto& kernels = pair_kernels();
  team.run(n.clusters, 16, [&](int from, int to) {
    std::vector<std::uint32_t> candidates, kept;
    for (int c = from; c < to; ++c) {
      float low[3] = {far_away, far_away, far_away}, high[3] = {-far_away, -far_away, -far_away}, reach = 0.0f;
      for (int i = c * lanes; i < (c + 1) * lanes; ++i) {
        if (particles.id[i] < 0) continue;
        for (int a = 0; a < 3; ++a) {
          low[a] = std::min(low[a], n.records[i * record::size + a]);
          high[a] = std::max(high[a], n.records[i * record::size + a]);
        }
        reach = std::max(reach, n.reach[i]);
      }
      const float around = 1.02f * static_cast<float>(n.grid.support) + reach + longest;
      candidates.clear();
      const int x0 = cells.column(low[0] - around), x1 = cells.column(high[0] + around);
      const int y0 = cells.row(low[1] - around), y1 = cells.row(high[1] + around);
      for (int ix = x0; ix <= x1; ++ix)
        for (int iy = y0; iy <= y1; ++iy) {
          const auto begin = entries.begin() + cell_first[ix * cells.ny + iy],
                     end = entries.begin() + cell_first[ix * cells.ny + iy + 1];
          auto e = std::lower_bound(begin, end, low[2] - around, [](const Entry& a, float z) { return a.z < z; });
          for (; e != end && e->z <= high[2] + around; ++e) candidates.push_back(e->index);
        }
      kept.resize(candidates.size() + 1);
      const int found = kernels.filter({n.records.data(), n.reach.data()}, c, candidates.data(),
                                       static_cast<int>(candidates.size()), kept.data());
      lists[c].assign(kept.begin(), kept.begin() + found);
    }
  });
  n.first.resize(n.clusters + 1);
  n.first[0] = 0;
  for (int c = 0; c < n.clusters; ++c) n.first[c + 1] = n.first[c] + static_cast<std::uint32_t>(lists[c].size());
  n.list.resize(n.first.back());
  for (int c = 0; c < n.clusters; ++c) std::copy(lists[c].begin(), lists[c].end(), n.list.begin() + n.first[c]);
  n.internal.assign(n.clusters, 0.0), n.viscous.assign(n.clusters, 0.0), n.damped.assign(n.clusters, 0.0);
}

}  // namespace apc::sph
