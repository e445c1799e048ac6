#include "sph_backend/neighbours.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

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

/// room.entries by cell and height into room.sorted, and where each cell begins. Equal heights by index, so that the
/// result depends on nothing but the state.
void sort_entries(RenewalRoom& room, int cells, Team& team) {
  const int count = static_cast<int>(room.entries.size()), pieces = (count + piece - 1) / piece;
  room.counts.resize(pieces);
  team.run(pieces, 1, [&](int first, int last) {
    for (int k = first; k < last; ++k) {
      room.counts[k].assign(cells, 0);
      for (int i = k * piece; i < std::min((k + 1) * piece, count); ++i)
        if (room.entries[i].cell >= 0) ++room.counts[k][room.entries[i].cell];
    }
  });
  // Where each piece puts its first entry of each cell.
  room.cell_first.resize(cells + 1);
  std::uint32_t next = 0;
  for (int c = 0; c < cells; ++c) {
    room.cell_first[c] = next;
    for (auto& counts : room.counts) next += std::exchange(counts[c], next);
  }
  room.cell_first[cells] = next;
  room.sorted.resize(next);
  team.run(pieces, 1, [&](int first, int last) {
    for (int k = first; k < last; ++k)
      for (int i = k * piece; i < std::min((k + 1) * piece, count); ++i)
        if (const CellEntry& e = room.entries[i]; e.cell >= 0) room.sorted[room.counts[k][e.cell]++] = e;
  });
  team.run(cells, 16, [&](int first, int last) {
    for (int c = first; c < last; ++c)
      std::sort(room.sorted.begin() + room.cell_first[c], room.sorted.begin() + room.cell_first[c + 1],
                [](const CellEntry& a, const CellEntry& b) { return a.z != b.z ? a.z < b.z : a.index < b.index; });
  });
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

/// Records by cell and height, with all that decides whether they are neighbours.
void sort_records(Neighbours& n, const Particles& particles, const Cells& cells, Team& team) {
  RenewalRoom& room = n.room;
  const std::size_t count = particles.size();
  room.entries.resize(count + n.images.size());
  team.run(static_cast<int>(room.entries.size()), piece, [&](int first, int last) {
    for (int i = first; i < last; ++i) {
      const float* r = &n.records[static_cast<std::size_t>(i) * record::size];
      const bool empty = static_cast<std::size_t>(i) < count && particles.id[i] < 0;
      room.entries[i] = {empty ? -1 : cells.cell(r[record::x], r[record::y]), r[record::z],
                         static_cast<std::uint32_t>(i)};
    }
  });
  sort_entries(room, cells.count(), team);
  const std::size_t size = room.sorted.size() + whole_vector;
  room.number.resize(size), room.quarter_inverse_h.resize(size), room.reach.resize(size);
  for (auto& a : room.at) a.resize(size);
  team.run(static_cast<int>(room.sorted.size()), piece, [&](int first, int last) {
    for (int k = first; k < last; ++k) {
      const std::uint32_t i = room.sorted[k].index;
      const float* r = &n.records[static_cast<std::size_t>(i) * record::size];
      room.number[k] = i, room.reach[k] = n.reach[i], room.quarter_inverse_h[k] = r[record::quarter_inverse_h];
      for (int a = 0; a < 3; ++a) room.at[a][k] = r[record::x + a];
    }
  });
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
void find_neighbours(const Box& box, float around, const Cells& cells, const RenewalRoom& s,
                     std::vector<std::uint32_t>& out) {
  const auto& kernels = pair_kernels();
  const Candidates candidates{
      {s.at[0].data(), s.at[1].data(), s.at[2].data()}, s.quarter_inverse_h.data(), s.reach.data(), s.number.data()};
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
/// Returns the longest.
float set_reach(Neighbours& n, const Particles& particles, Team& team) {
  const int count = static_cast<int>(particles.size());
  const float spacing = static_cast<float>(n.grid.spacing), dt = static_cast<float>(n.grid.dt);
  n.reach.resize(count), n.built_at.resize(3 * particles.size());
  std::vector<float> longest((count + piece - 1) / piece, 0.0f);
  team.run(static_cast<int>(longest.size()), 1, [&](int from, int to) {
    for (int k = from; k < to; ++k)
      for (int i = k * piece; i < std::min((k + 1) * piece, count); ++i) {
        const float* r = &n.records[static_cast<std::size_t>(i) * record::size];
        const float speed =
            std::sqrt(r[record::vx] * r[record::vx] + r[record::vy] * r[record::vy] + r[record::vz] * r[record::vz]);
        n.reach[i] =
            particles.hold[i] == hold_all ? 0.0f : std::min(0.02f * spacing + 9.0f * dt * speed, 0.6f * spacing);
        longest[k] = std::max(longest[k], n.reach[i]);
        for (int a = 0; a < 3; ++a) n.built_at[3 * i + a] = r[record::x + a];
      }
  });
  return *std::max_element(longest.begin(), longest.end());
}

/// The room for sorted values of a type.
auto& sorted_room(RenewalRoom& room, const std::vector<double>&) { return room.doubles; }
auto& sorted_room(RenewalRoom& room, const std::vector<float>&) { return room.floats; }
auto& sorted_room(RenewalRoom& room, const std::vector<std::int32_t>&) { return room.integers; }
auto& sorted_room(RenewalRoom& room, const std::vector<std::uint8_t>&) { return room.bytes; }

}  // namespace

int sort_particles(Particles& particles, Neighbours& n, double rear, Team& team) {
  const NeighbourGrid& grid = n.grid;
  RenewalRoom& room = n.room;
  const Cells cells(grid);
  room.entries.resize(particles.size());
  team.run(static_cast<int>(room.entries.size()), piece, [&](int first, int last) {
    for (int i = first; i < last; ++i) {
      const bool gone = particles.id[i] < 0 || particles.x[i] < rear;
      room.entries[i] = {gone ? -1
                              : cells.cell(static_cast<float>(particles.x[i] - grid.origin[0]),
                                           static_cast<float>(particles.y[i] - grid.origin[1])),
                         static_cast<float>(particles.z[i] - grid.origin[2]), static_cast<std::uint32_t>(i)};
    }
  });
  sort_entries(room, cells.count(), team);

  constexpr std::uint32_t empty = 0xffffffffu;
  const auto& cell_first = room.cell_first;
  auto& first_of = room.order_first;  // of the cells in the order to come
  first_of.assign(cells.count() + 1, 0);
  for (int c = 0; c < cells.count(); ++c)
    first_of[c + 1] = first_of[c] + (cell_first[c + 1] - cell_first[c] + lanes - 1) / lanes * lanes;
  auto& order = room.order;
  order.assign((first_of.back() + whole_vector - 1) / whole_vector * whole_vector, empty);
  team.run(cells.count(), 16, [&](int from, int to) {
    std::vector<Place> places;
    for (int c = from; c < to; ++c) {
      places.clear();
      for (std::uint32_t k = cell_first[c]; k < cell_first[c + 1]; ++k) {
        const std::uint32_t i = room.sorted[k].index;
        places.push_back({{static_cast<float>(particles.x[i] - grid.origin[0]),
                           static_cast<float>(particles.y[i] - grid.origin[1]), room.sorted[k].z},
                          i});
      }
      cut(places.data(), places.data() + places.size(), static_cast<float>(grid.support));
      for (std::size_t k = 0; k < places.size(); ++k) order[first_of[c] + k] = places[k].index;
    }
  });
  const int count = static_cast<int>(order.size());
  for_each_field(particles, [&](auto& field) {
    auto& sorted = sorted_room(room, field);
    sorted.resize(order.size());
    team.run(count, piece, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) sorted[i] = order[i] == empty ? 0 : field[order[i]];
    });
    field.swap(sorted);
  });
  team.run(count, piece, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      if (order[i] != empty) continue;
      particles.id[i] = -1, particles.stretch[i] = 1.0f;
      particles.hold[i] = hold_all;
      particles.x[i] = particles.y[i] = particles.z[i] = far_away;
    }
  });
  return static_cast<int>(room.sorted.size());
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
  const float longest = set_reach(n, particles, team);
  const float support = static_cast<float>(n.grid.support);
  n.images = make_images(n.records, particles.id, count, n.grid.planes, n.grid.origin, support + 2.0f * longest, team);
  add_records(n, count);
  refresh_motion(n.records, count, n.images, team);
  refresh_stress(n.records, count, n.images, team);
  n.reach.resize(count + n.images.size());
  team.run(static_cast<int>(n.images.size()), piece, [&](int first, int last) {
    for (int k = first; k < last; ++k) n.reach[count + k] = n.reach[n.images[k].parent];
  });

  sort_records(n, particles, cells, team);
  constexpr int together = 32;  // clusters of one piece
  const auto nothing = static_cast<std::uint32_t>(count + n.images.size());
  auto& lists = n.room.lists;
  lists.resize((n.clusters + together - 1) / together);
  n.first.assign(n.clusters + 1, 0);
  team.run(n.clusters, together, [&](int from, int to) {
    for (int begin = from; begin < to; begin += together) {  // one thread alone is given all at once
      auto& list = lists[begin / together];
      list.clear();
      for (int c = begin; c < std::min(begin + together, to); ++c) {
        const std::size_t before = list.size();
        Box box = box_of(n, particles, c);
        box.support = 1.0001f * support;
        if (box.high[0] >= box.low[0]) find_neighbours(box, box.support + box.reach + longest, cells, n.room, list);
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
