/// A plot of histories as SVG: against distance and against time, with ticks in field units and SI, all four in one
/// drawing of which the page's style sheet shows one. Readable without any script.
#pragma once

#include <string>
#include <vector>

#include "apc/report/unit_system.h"

namespace apc::report {

/// One line of a plot. `look` names a style: "nose", "main", "third", "fourth", "total"; "rut-…" is dashed and shares
/// its gear's key.
struct Curve {
  std::string name, look;
  std::vector<double> values;  ///< SI, one per row of the axes
};

/// A horizontal line: a limit, an available stroke.
struct Level {
  std::string name, look;  ///< look: "limit", "ultimate", or a gear's
  double value = 0.0;      ///< SI
};

struct Plot {
  std::string title;
  Measure measure;
  std::vector<Curve> curves;
  std::vector<Level> levels;
  std::string note = {};  ///< HTML under the title; empty = the curves' extremes
};

/// The two horizontal axes all plots of a page share.
struct Abscissa {
  std::vector<double> distance, time;                                                         ///< m, s
  std::string place = "nose wheel from the bed's edge", moment = "time from the bed's edge";  ///< titles
};

/// A <figure> with title, legend, a line that states the extremes, and the drawing. `number` tells plots apart.
std::string figure(const Plot&, const Abscissa&, std::size_t number);

}  // namespace apc::report
