/// The end of a runway where a bed shall lie (schema "apc-site/1"), the bed placed on it, and the drawing that goes to
/// others as GeoJSON (RFC 7946) and KML.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "apc/base/json.h"
#include "apc/bed/bed.h"
#include "apc/site/geodesy.h"

namespace apc::site {

struct Site {
  std::string name, source;
  Place end;                                       ///< of the pavement, on the centreline
  double heading = 0.0;                            ///< rad from true north, of the aircraft that overrun this end
  double runway_width = 0.0;                       ///< m
  double safety_length = 0.0, safety_width = 0.0;  ///< m, of the safety area behind the pavement end
  double minimum_setback = 0.0;                    ///< m
  double grade = 0.0;                              ///< rise over run
  double elevation = 0.0;                          ///< m, of the pavement end above mean sea level
  /// m from the pavement end back along the runway to where aircraft landing the other way may touch down.
  double displaced_threshold = 0.0;
};

Site load_site(const std::filesystem::path&);
Site read_site(const Json&);
/// The file that `load_site` reads back: degrees with nine decimals (a tenth of a millimetre), lengths in metres.
std::string site_json(const Site&);

/// A rectangle on the ground, counterclockwise seen from above (the right-hand rule of RFC 7946): near left, near
/// right, far right, far left of the centreline.
using Corners = std::array<Place, 4>;

/// Between two distances behind the pavement end, `width` across, centred on the extended centreline.
Corners area(const Site&, double from, double to, double width);

/// One fact about the placing; `met` false = the bed does not fit.
struct Check {
  std::string what;
  double value = 0.0, limit = 0.0;  ///< m, or rise over run for the grade
  bool met = false;
  bool grade = false;
};

/// Set-back, length, width against runway and safety area, grade. InputError when the safety area ends before the bed's
/// leading edge: no part of such a bed lies on the site.
std::vector<Check> fit(const Site&, const bed::Bed&);

/// Schema "apc-placing/1": the site and the facts about the placing, SI.
std::string placing_json(const Site&, const std::vector<Check>&);
std::string geojson(const Site&, const bed::Bed&);
std::string kml(const Site&, const bed::Bed&);

}  // namespace apc::site
