/// Order of the particles and the neighbour list of every cluster.
///
/// The plan view is cut into square cells of two spacings; the particles of a cell are sorted by height and cut into
/// clusters of 8: by height, and across where the foam is crushed, so that a cluster stays compact. A list holds
/// whatever may come within reach of the box around the 8 before the next renewal: every particle may travel its own
/// `reach`, chosen from its speed, so the list is tight where the foam rests and generous under the wheel. A list is
/// renewed when a particle outruns its reach.
#pragma once

#include <cstdint>
#include <vector>

#include "sph_backend/mirror.h"
#include "sph_backend/particles.h"
#include "sph_backend/team.h"

namespace apc::sph {

struct NeighbourGrid {
  double spacing = 0.0;
  double origin[3] = {0.0, 0.0, 0.0};  ///< positions in records are relative to it, so that floats resolve them
  double extent[2] = {0.0, 0.0};       ///< of the block in x and y, from the origin
  double support = 0.0;                ///< largest 2h
  double dt = 0.0;
  std::vector<MirrorPlane> planes;
};

/// A particle or record on its way into its cell.
struct CellEntry {
  int cell;  ///< negative: left out
  float z;
  std::uint32_t index;
};

/// Room that every renewal needs again.
struct RenewalRoom {
  std::vector<CellEntry> entries, sorted;
  std::vector<std::uint32_t> cell_first, order_first, order, number;
  std::vector<float> at[3], quarter_inverse_h, reach;  ///< of the sorted records
  std::vector<std::vector<std::uint32_t>> counts, lists;
  std::vector<double> doubles;
  std::vector<float> floats;
  std::vector<std::int32_t> integers;
  std::vector<std::uint8_t> bytes;
};

struct Neighbours {
  NeighbourGrid grid;
  int clusters = 0;
  std::vector<float> records;  ///< particles (padded), then images, then one of nothing
  std::vector<Image> images;
  std::vector<std::uint32_t> list, first;         ///< of each cluster; an odd list is filled up with nothing
  std::vector<float> reach;                       ///< per record
  std::vector<float> built_at;                    ///< positions at renewal, 3 per particle
  std::vector<double> internal, viscous, damped;  ///< per cluster, of this step
  RenewalRoom room;
};

/// Puts the particles into cluster order, dropping empty lanes and particles behind x = `rear`; returns how many stay.
int sort_particles(Particles&, Neighbours&, double rear, Team&);
/// Images and lists for sorted particles whose records are filled in.
void build_lists(Neighbours&, const Particles&, Team&);
/// Room for the records of the images and of nothing behind those of `particles`.
void add_records(Neighbours&, std::size_t particles);

}  // namespace apc::sph
