/// A finished design with everything its reports need.
#pragma once

#include "apc/design/pareto.h"
#include "apc/report/record.h"
#include "apc/report/unit_system.h"

namespace apc::report {

struct DesignRecord {
  design::Fleet fleet;
  std::string fleet_text;  ///< the fleet's file as it was read, kept inside the design
  design::Design design;
  std::vector<design::FrontPoint> front;
  double seconds = 0.0;
  unsigned threads = 0;
  Manifest manifest;
};

/// Schema "apc-design/1": bed, length, volume, aircraft[], certificate, …
std::string design_json(const DesignRecord&);
/// The built bed alone, schema "apc-bed/1".
std::string bed_json(const bed::Bed&);
std::string design_brief(const DesignRecord&, UnitSystem);
std::string design_page(const DesignRecord&);

/// Rows of equal depth, from the leading edge: "rows 12–40: 18 in".
struct RowRun {
  std::size_t first = 0, last = 0;
  double depth = 0.0;
};
std::vector<RowRun> row_runs(const design::Blocks&);

}  // namespace apc::report
