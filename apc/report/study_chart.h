/// A chart of one quantity over another as SVG, with ticks in field units and SI: lines, points that stand out, and
/// lines across at limits. Readable without any script, on paper and in the dark.
#pragma once

#include <string>
#include <vector>

#include "apc/report/unit_system.h"

namespace apc::report {

/// `look` names a style of the page: "nose", "main", "third", "fourth", "total", or the same with "rut-" before it
/// (dashed).
struct ChartLine {
  std::string name, look;    ///< the name is HTML
  std::vector<double> x, y;  ///< SI; breaks where y is not finite
};

/// Points with a ring: where a limit is passed, for instance.
struct ChartMarks {
  std::string name;
  std::vector<double> x, y;
};

struct ChartLevel {
  std::string name, look;  ///< "limit", "ultimate" or a line's look
  double value = 0.0;
};

struct Chart {
  std::string title;
  Measure along, up;
  std::string along_title;
  std::vector<ChartLine> lines;
  std::vector<ChartMarks> marks;
  std::vector<ChartLevel> levels;     ///< across, at a value of `up`
  std::vector<ChartLevel> verticals;  ///< upright, at a value of `along`
  std::string note;                   ///< below the title; HTML
  double highest = 0.0;               ///< SI; the axis ends there at the latest; 0 = at the largest value
};

std::string figure(const Chart&);

/// The look of the i-th line: five colours, then the same dashed.
std::string line_look(std::size_t i);

/// One input's bar of a tornado: its range and what the quantity becomes at either end.
struct TornadoRow {
  std::string name, low_name, high_name;
  double low = 0.0, high = 0.0;
};

/// Bars around the centre's value, longest first as given.
std::string tornado_figure(const std::string& title, double centre, const Measure&, const std::vector<TornadoRow>&);

}  // namespace apc::report
