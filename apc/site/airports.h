/// Runway ends from an open airport data set in the format of OurAirports (ourairports.com/help/data-dictionary.html):
/// a folder with `runways.csv` and, for names, `airports.csv`. The set is read where it is installed; none is shipped
/// and no other part of the program needs one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "apc/site/site.h"

namespace apc::site {

/// One runway in the direction in which aircraft use it, with the end that they overrun.
struct RunwayEnd {
  std::string airport, name, runway, opposite;  ///< "XKAP", "Example Regional", "09", "27" (the overrun end's own name)
  Place end;                                    ///< of the pavement that is overrun
  double heading = 0.0;                         ///< rad from true north, of the overrun
  double length = 0.0, width = 0.0;             ///< m, of the runway
  double elevation = 0.0;                       ///< m; 0 when the set gives none
  double displaced_threshold = 0.0;             ///< m, of the landing the other way; 0 when the set gives none
  double resolution = 0.0;                      ///< m, that the decimals of the coordinates can tell apart
  std::string source;                           ///< file and row, and where the heading comes from
};

/// The folder of the installed set: `given`, otherwise $APC_AIRPORTS, otherwise share/apc/airports of the shipped data.
/// InputError when there is no runways.csv: says where it was looked for and what to do.
std::filesystem::path airport_folder(const std::filesystem::path& given);

/// `airport` is the set's ident, or an ICAO, IATA or local code when airports.csv is there; `runway` is the one in use
/// ("09"): its far end is overrun. InputError when either is unknown (lists what there is), closed, or without the
/// coordinates of its far end; and when coordinates, heading and length contradict each other.
RunwayEnd find_runway_end(const std::filesystem::path& folder, const std::string& airport, const std::string& runway);

/// The site of that end; the set knows nothing of safety areas.
Site site_of(const RunwayEnd&, double safety_length, double safety_width, double minimum_setback);

/// Rows of cells of a CSV text whose cells may be quoted and then hold commas, quotes ("" = one) and line breaks
/// (RFC 4180). InputError when a quote is not closed.
std::vector<std::vector<std::string>> cells_of(const std::string& text, const std::string& name);

}  // namespace apc::site
