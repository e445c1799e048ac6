#include "sph_backend/neighbours.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sph_backend/pair_kernels.h"

namespace apc::sph {
namespace {

constexpr double cell_spacings = 2.0;
constexpr float far_away = 1e4f;
constexpr int piece = 2048;  // particles of one piece of work

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
  int cell;  ///< negative: left out
  float z;
  std::uint32_t index;
};

/// Entries by cell and height, and where each cell begins. Equal heights by index, so that the result depends on
/// nothing but the state.
void sort_entries(std::vector<Entry>& entries, std::vector<std::uint32_t>& cell_first, int cells, Team& team) {
  cell_first.assign(cells + 1, 0);
  for (const auto& e : entries)
    if (e.cell >= 0) ++cell_first[e.cell + 1];
  std::partial_sum(cell_first.begin(), cell_first.end(), cell_first.begin());
  std::vector<Entry> sorted(cell_first.back());
  std::vector<std::uint32_t> place(cell_first.begin(), cell_first.end() - 1);
  for (const auto& e : entries)
    if (e.cell >= 0) sorted[place[e.cell]++] = e;
  team.run(cells, 16, [&](int first, int last) {
    for (int c = first; c < last; ++c)
      std::sort(sorted.begin() + cell_first[c], sorted.begin() + cell_first[c + 1],
                [](const Entry& a, const Entry& b) { return a.z != b.z ? a.z < b.z : a.index < b.index; });
  });
  entries.swap(sorted);
}

/// A particle on its way into a cluster.
struct Place {
  float at[3];
  std::uint32_t index;
};

/// What lies within `r` of the box around some places (Steiner): the length of a cluster's list, in volumes.
float reached(const Place* first, const Place* last, float r) {
  float size[3];
  for (int a = 0; a < 3; ++a) {
    const auto [low, high] =
        std::minmax_element(first, last, [a](const Place& p, const Place& q) { return p.at[a] < q.at[a]; });
    size[a] = high->at[a] - low->at[a];
  }
  const float sides = size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  return size[0] * size[1] * size[2] + 2.0f * sides * r + 3.14f * (size[0] + size[1] + size[2]) * r * r;
}

/// Cuts places sorted by height into clusters, in halves: by height, or across where that leaves shorter lists because
/// the foam is crushed. A lattice of cells two spacings wide gives cubes of 2 × 2 × 2.
void cut(Place* first, Place* last, float r) {
  const auto count = last - first;
  if (count <= lanes) return;
  const auto whole = (count + lanes - 1) / lanes;  // clusters; the last one may be short
  Place* const middle = first + (whole + 1) / 2 * lanes;
  const float cell = 0.9f * r;  // support of 2.4 spacings, cells of two
  if (last[-1].at[2] - first->at[2] < 1.5f * cell) {
    const auto by = [](int a) {
      return [a](const Place& p, const Place& q) { return p.at[a] != q.at[a] ? p.at[a] < q.at[a] : p.index < q.index; };
    };
    float best = reached(first, middle, r) + reached(middle, last, r);
    std::vector<Place> chosen;
    for (const int a : {0, 1}) {
      std::vector<Place> other(first, last);
      std::nth_element(other.begin(), other.begin() + (middle - first), other.end(), by(a));
      const float now = reached(other.data(), other.data() + (middle - first), r) +
                        reached(other.data() + (middle - first), other.data() + count, r);
      if (now < 0.98f * best) best = now, chosen.swap(other);
    }
    if (!chosen.empty()) {
      std::copy(chosen.begin(), chosen.end(), first);
      std::sort(first, middle, by(2));
      std::sort(middle, last, by(2));
    }
  }
  cut(first, middle, r);
  cut(middle, last, r);
}

/// Sorted entries with all that decides whether they are neighbours.
struct Sorted {
  std::vector<std::uint32_t> number, cell_first;
  std::vector<float> at[3], quarter_inverse_h, reach;

  Candidates view() const {
    return {{at[0].data(), at[1].data(), at[2].data()}, quarter_inverse_h.data(), reach.data(), number.data()};
  }
};

Sorted sort_records(const Neighbours& n, const Particles& particles, const Cells& cells, Team& team) {
  const std::size_t count = particles.size();
  std::vector<Entry> entries(count + n.images.size());
  team.run(static_cast<int>(entries.size()), piece, [&](int first, int last) {
    for (int i = first; i < last; ++i) {
      const float* r = &n.records[static_cast<std::size_t>(i) * record::size];
      const bool empty = static_cast<std::size_t>(i) < count && particles.id[i] < 0;
      entries[i] = {empty ? -1 : cells.cell(r[record::x], r[record::y]), r[record::z], static_cast<std::uint32_t>(i)};
    }
  });
  Sorted s;
  sort_entries(entries, s.cell_first, cells.count(), team);
  const std::size_t room = entries.size() + whole_vector;
  s.number.resize(room), s.quarter_inverse_h.resize(room), s.reach.resize(room);
  for (auto& a : s.at) a.resize(room);
  team.run(static_cast<int>(entries.size()), piece, [&](int first, int last) {
    for (int k = first; k < last; ++k) {
      const std::uint32_t i = entries[k].index;
      const float* r = &n.records[static_cast<std::size_t>(i) * record::size];
      s.number[k] = i, s.reach[k] = n.reach[i], s.quarter_inverse_h[k] = r[record::quarter_inverse_h];
      for (int a = 0; a < 3; ++a) s.at[a][k] = r[record::x + a];
    }
  });
  return s;
}

Box box_of(const Neighbours& n, const Particles& particles, int cluster) {
  Box box{{far_away, far_away, far_away}, {-far_away, -far_away, -far_away}, far_away, 0.0f, 0.0f};
  for (int i = cluster * lanes; i < (cluster + 1) * lanes; ++i) {
    if (particles.id[i] < 0) continue;
    const float* r = &n.records[static_cast<std::size_t>(i) * record::size];
    for (int a = 0; a < 3; ++a)
      box.low[a] = std::min(box.low[a], r[record::x + a]), box.high[a] = std::max(box.high[a], r[record::x + a]);
    box.quarter_inverse_h = std::min(box.quarter_inverse_h, r[record::quarter_inverse_h]);
    box.reach = std::max(box.reach, n.reach[i]);
  }
  return box;
}

/// Appends the neighbours of the box to `out`.
void find_neighbours(const Box& box, float around, const Cells& cells, const Sorted& s,
                     std::vector<std::uint32_t>& out) {
  const auto& kernels = pair_kernels();
  const Candidates candidates = s.view();
  const int x0 = cells.column(box.low[0] - around), x1 = cells.column(box.high[0] + around);
  const int y0 = cells.row(box.low[1] - around), y1 = cells.row(box.high[1] + around);
  for (int ix = x0; ix <= x1; ++ix)
    for (int iy = y0; iy <= y1; ++iy) {
      const std::uint32_t cell = ix * cells.ny + iy;
      const auto begin = s.at[2].begin() + s.cell_first[cell], end = s.at[2].begin() + s.cell_first[cell + 1];
      const auto first = std::lower_bound(begin, end, box.low[2] - around),
                 last = std::upper_bound(first, end, box.high[2] + around);
      const std::size_t before = out.size(), most = static_cast<std::size_t>(last - first);
      if (most == 0) continue;
      out.resize(before + most + whole_vector);
      out.resize(before + kernels.filter(candidates, box, static_cast<int>(first - s.at[2].begin()),
                                         static_cast<int>(last - s.at[2].begin()), &out[before]));
    }
}

/// How far each particle may travel before the list is renewed: some steps at its present speed and a little more.
void set_reach(Neighbours& n, const Particles& particles, Team& team) {
  const std::size_t count = particles.size();
  const float spacing = static_cast<float>(n.grid.spacing), dt = static_cast<float>(n.grid.dt);
  n.reach.resize(count), n.built_at.resize(3 * count);
  team.run(static_cast<int>(count), piece, [&](int first, int last) {
    for (int i = first; i < last; ++i) {
      const float* r = &n.records[static_cast<std::size_t>(i) * record::size];
      const float speed =
          std::sqrt(r[record::vx] * r[record::vx] + r[record::vy] * r[record::vy] + r[record::vz] * r[record::vz]);
      n.reach[i] = particles.hold[i] == hold_all ? 0.0f : std::min(0.02f * spacing + 9.0f * dt * speed, 0.6f * spacing);
      for (int a = 0; a < 3; ++a) n.built_at[3 * i + a] = r[record::x + a];
    }
  });
}

}  // namespace

int sort_particles(Particles& particles, const NeighbourGrid& grid, double rear, Team& team) {
  const Cells cells(grid);
  std::vector<Entry> entries(particles.size());
  team.run(static_cast<int>(entries.size()), piece, [&](int first, int last) {
    for (int i = first; i < last; ++i) {
      const bool gone = particles.id[i] < 0 || particles.x[i] < rear;
      entries[i] = {gone ? -1
                         : cells.cell(static_cast<float>(particles.x[i] - grid.origin[0]),
                                      static_cast<float>(particles.y[i] - grid.origin[1])),
                    static_cast<float>(particles.z[i] - grid.origin[2]), static_cast<std::uint32_t>(i)};
    }
  });
  std::vector<std::uint32_t> cell_first;
  sort_entries(entries, cell_first, cells.count(), team);

  constexpr std::uint32_t empty = 0xffffffffu;
  std::vector<std::uint32_t> first(cells.count() + 1, 0);  // of the cells in the order to come
  for (int c = 0; c < cells.count(); ++c)
    first[c + 1] = first[c] + (cell_first[c + 1] - cell_first[c] + lanes - 1) / lanes * lanes;
  std::vector<std::uint32_t> order((first.back() + whole_vector - 1) / whole_vector * whole_vector, empty);
  team.run(cells.count(), 16, [&](int from, int to) {
    std::vector<Place> places;
    for (int c = from; c < to; ++c) {
      places.clear();
      for (std::uint32_t k = cell_first[c]; k < cell_first[c + 1]; ++k) {
        const std::uint32_t i = entries[k].index;
        places.push_back({{static_cast<float>(particles.x[i] - grid.origin[0]),
                           static_cast<float>(particles.y[i] - grid.origin[1]), entries[k].z},
                          i});
      }
      cut(places.data(), places.data() + places.size(), static_cast<float>(grid.support));
      for (std::size_t k = 0; k < places.size(); ++k) order[first[c] + k] = places[k].index;
    }
  });
  const int count = static_cast<int>(order.size());
  for_each_field(particles, [&](auto& field) {
    using Value = typename std::decay_t<decltype(field)>::value_type;
    std::vector<Value> sorted(order.size());
    team.run(count, piece, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) sorted[i] = order[i] == empty ? Value{} : field[order[i]];
    });
    field.swap(sorted);
  });
  for (int i = 0; i < count; ++i) {
    if (order[i] != empty) continue;
    particles.id[i] = -1, particles.stretch[i] = 1.0f;
    particles.hold[i] = hold_all;
    particles.x[i] = particles.y[i] = particles.z[i] = far_away;
  }
  return static_cast<int>(entries.size());
}

void add_records(Neighbours& n, std::size_t particles) {
  n.records.resize((particles + n.images.size() + 1) * record::size);
  float* nothing = &n.records[(particles + n.images.size()) * record::size];
  std::fill(nothing, nothing + record::size, 0.0f);
  // Beyond the support of everything, empty lanes included; no volume and no stress.
  nothing[record::x] = nothing[record::y] = nothing[record::z] = -far_away;
  nothing[record::quarter_inverse_h] = static_cast<float>(0.5 / n.grid.support);
}

void build_lists(Neighbours& n, const Particles& particles, Team& team) {
  const Cells cells(n.grid);
  const std::size_t count = particles.size();
  n.clusters = static_cast<int>(count / lanes);
  set_reach(n, particles, team);
  const float longest = *std::max_element(n.reach.begin(), n.reach.end());
  const float support = static_cast<float>(n.grid.support);
  n.images = make_images(n.records, particles.id, count, n.grid.planes, n.grid.origin, support + 2.0f * longest, team);
  add_records(n, count);
  refresh_motion(n.records, count, n.images, team);
  refresh_stress(n.records, count, n.images, team);
  for (const auto& image : n.images) n.reach.push_back(n.reach[image.parent]);

  const Sorted sorted = sort_records(n, particles, cells, team);
  constexpr int together = 32;  // clusters of one piece
  const auto nothing = static_cast<std::uint32_t>(count + n.images.size());
  std::vector<std::vector<std::uint32_t>> lists((n.clusters + together - 1) / together);
  n.first.assign(n.clusters + 1, 0);
  team.run(n.clusters, together, [&](int from, int to) {
    for (int begin = from; begin < to; begin += together) {  // one thread alone is given all at once
      auto& list = lists[begin / together];
      list.reserve(together * 200);
      for (int c = begin; c < std::min(begin + together, to); ++c) {
        const std::size_t before = list.size();
        Box box = box_of(n, particles, c);
        box.support = 1.0001f * support;
        if (box.high[0] >= box.low[0]) find_neighbours(box, box.support + box.reach + longest, cells, sorted, list);
        if (list.size() % 2 == 1) list.push_back(nothing);
        n.first[c + 1] = static_cast<std::uint32_t>(list.size() - before);
      }
    }
  });
  std::partial_sum(n.first.begin(), n.first.end(), n.first.begin());
  n.list.resize(n.first.back());
  team.run(static_cast<int>(lists.size()), 1, [&](int from, int to) {
    for (int k = from; k < to; ++k) std::copy(lists[k].begin(), lists[k].end(), n.list.begin() + n.first[k * together]);
  });
  n.internal.assign(n.clusters, 0.0), n.viscous.assign(n.clusters, 0.0), n.damped.assign(n.clusters, 0.0);
}

}  // namespace apc::sph
