/// The peaks of a load along the way, one per window: what a search by gradients needs, because the largest peak of all
/// has a kink in the design wherever two peaks are equal, and at an optimum they usually are. The peak in a window is
/// smooth while one peak leads in it: as that passes an edge, the value at the edge takes over with the same slope.
/// Where a load is flat the lead goes from edge to edge, so the values at the edges and at the end come along for
/// themselves.
#pragma once

#include <vector>

namespace apc::design {

/// Largest value between each pair of neighbouring `edges`, then the value at each edge, then at the end, of a curve
/// given by samples (`place` advances). Peaks between samples are vertices of parabolas through three of them. The
/// curve ends 0.05 m before its last place, where drag dies with the motion; beyond, it is continued falling by 0.02
/// per metre, so that a stop which moves past an edge changes nothing abruptly and a window nobody reaches holds no
/// design. 2 E numbers for E edges.
std::vector<double> window_peaks(const std::vector<double>& place, const std::vector<double>& value,
                                 const std::vector<double>& edges);

}  // namespace apc::design
