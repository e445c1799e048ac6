#include "apc/site/airports.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>

#include "apc/base/file.h"
#include "apc/base/require.h"
#include "apc/base/units.h"

namespace apc::site {
namespace fs = std::filesystem;
namespace {

/// A table of texts whose columns are asked for by name.
class Table {
 public:
  explicit Table(const fs::path& path) : file_(path.string()), rows_(cells_of(read_text(path), path.string())) {
    require(!rows_.empty(), file_, ": is empty. Install the data set again");
    for (std::size_t i = 0; i < rows_.front().size(); ++i) columns_[rows_.front()[i]] = i;
  }
  std::size_t rows() const { return rows_.size(); }  ///< row 0 is the header
  const std::string& file() const { return file_; }
  bool has(const std::string& column) const { return columns_.contains(column); }
  std::string at(std::size_t row, const std::string& column) const {
    const auto found = columns_.find(column);
    require(found != columns_.end(), file_, ": has no column \"", column,
            "\". A set in the format of OurAirports is needed");
    return found->second < rows_[row].size() ? rows_[row][found->second] : std::string();
  }
  /// NaN for an empty cell.
  double number(std::size_t row, const std::string& column) const {
    const auto text = at(row, column);
    if (text.empty()) return std::nan("");
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    require(*end == '\0' && std::isfinite(value), file_, " row ", row + 1, ", ", column, ": \"", text,
            "\" is no number");
    return value;
  }

 private:
  std::string file_;
  std::vector<std::vector<std::string>> rows_;
  std::map<std::string, std::size_t> columns_;
};

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (const auto& each : words) out += (out.empty() ? "" : ", ") + each;
  return out;
}

struct Airport {
  std::string ident, name;
};

/// By ident, or by any of the codes that airports.csv knows.
Airport find_airport(const fs::path& folder, const std::string& code) {
  std::error_code error;
  if (!fs::exists(folder / "airports.csv", error)) return {code, code};
  const Table table(folder / "airports.csv");
  for (const char* column : {"ident", "icao_code", "gps_code", "iata_code", "local_code"}) {
    if (!table.has(column)) continue;  // sets differ in their codes by age
    for (std::size_t row = 1; row < table.rows(); ++row)
      if (table.at(row, column) == code) return {table.at(row, "ident"), table.at(row, "name")};
  }
  throw InputError(concat(table.file(), ": knows no airport \"", code, "\". Write its ICAO code, such as XKAP"));
}

/// The distance that the last decimal of a coordinate moves on the ground.
double resolution_of(const std::string& degrees) {
  const auto point = degrees.find('.');
  const auto decimals = point == std::string::npos ? 0 : degrees.size() - point - 1;
  return std::pow(10.0, -static_cast<double>(decimals)) * units::deg * 6371e3;
}

Place place_of(const Table& table, std::size_t row, const std::string& side) {
  return {table.number(row, side + "_latitude_deg") * units::deg,
          table.number(row, side + "_longitude_deg") * units::deg};
}

double or_zero(double value) { return std::isfinite(value) ? value : 0.0; }

/// `near` and `far` are "le" and "he" in the direction of use.
RunwayEnd end_of(const Table& table, std::size_t row, const Airport& airport, const std::string& near,
                 const std::string& far) {
  RunwayEnd out;
  out.airport = airport.ident, out.name = airport.name;
  out.runway = table.at(row, near + "_ident"), out.opposite = table.at(row, far + "_ident");
  const auto where = concat(table.file(), " row ", row + 1, ", ", airport.ident, " runway ", out.runway, ": ");
  require(table.at(row, "closed") != "1", where, "is closed. Choose another runway, or write an apc-site/1 file");
  out.end = place_of(table, row, far);
  require(std::isfinite(out.end.latitude) && std::isfinite(out.end.longitude), where, "the coordinates of the end \"",
          out.opposite, "\" are missing. Write an apc-site/1 file (apc describe site)");
  out.length = or_zero(table.number(row, "length_ft")) * units::ft;
  out.width = table.number(row, "width_ft") * units::ft;
  require(out.width > 0, where, "its width is missing. Write an apc-site/1 file (apc describe site)");
  out.elevation = or_zero(table.number(row, far + "_elevation_ft")) * units::ft;
  out.displaced_threshold = or_zero(table.number(row, far + "_displaced_threshold_ft")) * units::ft;
  out.resolution = std::max(resolution_of(table.at(row, far + "_latitude_deg")),
                            resolution_of(table.at(row, far + "_longitude_deg")));

  const double written = table.number(row, near + "_heading_degT") * units::deg;
  const auto start = place_of(table, row, near);
  if (!std::isfinite(start.latitude) || !std::isfinite(start.longitude)) {
    require(std::isfinite(written), where, "neither its heading nor both its ends are known");
    out.heading = written;
    out.source = concat("heading as written in row ", row + 1, " of ", table.file());
    return out;
  }
  const auto run = way(start, out.end);
  require(run.length > 100, where, "its two ends lie ", run.length, " m apart. The row is wrong");
  // Coordinates are usually the better source of the two: headings are often rounded to a degree.
  out.heading = run.heading;
  const double turn = std::abs(std::remainder(written - run.heading, 2 * std::numbers::pi));
  require(!std::isfinite(written) || turn < 3 * units::deg, where, "its heading of ", written / units::deg,
          " deg contradicts its ends, which lie at ", run.heading / units::deg,
          " deg of each other. Write an apc-site/1 file with the right one");
  require(out.length == 0 || std::abs(run.length / out.length - 1) < 0.1, where, "its length of ", out.length,
          " m contradicts its ends, ", run.length, " m apart. Write an apc-site/1 file with the right end");
  out.source = concat("heading from the ends in row ", row + 1, " of ", table.file());
  return out;
}

}  // namespace

std::vector<std::vector<std::string>> cells_of(const std::string& text, const std::string& name) {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> row{""};
  bool quoted = false, any = false;
  for (std::size_t i = text.starts_with("\xEF\xBB\xBF") ? 3 : 0; i < text.size(); ++i) {
    const char letter = text[i];
    if (quoted) {
      if (letter != '"')
        row.back() += letter;
      else if (i + 1 < text.size() && text[i + 1] == '"')
        row.back() += text[++i];
      else
        quoted = false;
    } else if (letter == '"') {
      quoted = any = true;
    } else if (letter == ',') {
      row.emplace_back(), any = true;
    } else if (letter == '\n') {
      if (any) rows.push_back(std::move(row));
      row = {""}, any = false;
    } else if (letter != '\r') {
      row.back() += letter, any = true;
    }
  }
  require(!quoted, name, ": a quote is not closed before the end of the file. The file is damaged or cut off");
  if (any) rows.push_back(std::move(row));
  return rows;
}

fs::path airport_folder(const fs::path& given) {
  std::vector<fs::path> places;
  const char* named = std::getenv("APC_AIRPORTS");
  if (!given.empty())
    places = {given};
  else if (named && *named)
    places = {named};
  else
    places = {shipped("airports"), "/usr/share/apc/airports", "/usr/local/share/apc/airports"};
  std::error_code error;
  std::vector<std::string> looked;
  for (const auto& place : places) {
    if (fs::is_regular_file(place / "runways.csv", error)) return place;
    looked.push_back((place / "runways.csv").string());
  }
  throw InputError(
      concat("no airport data set is installed (looked for ", joined(looked),
             "). Put runways.csv and airports.csv of OurAirports into a folder and name it with --data DIR "
             "or APC_AIRPORTS; or write the runway end into an apc-site/1 file (apc describe site)"));
}

RunwayEnd find_runway_end(const fs::path& folder, const std::string& airport, const std::string& runway) {
  const auto which = find_airport(folder, airport);
  const Table table(folder / "runways.csv");
  std::vector<std::string> known;
  for (std::size_t row = 1; row < table.rows(); ++row) {
    if (table.at(row, "airport_ident") != which.ident) continue;
    const auto low = table.at(row, "le_ident"), high = table.at(row, "he_ident");
    if (low == runway) return end_of(table, row, which, "le", "he");
    if (high == runway) return end_of(table, row, which, "he", "le");
    for (const auto& each : {low, high})
      if (!each.empty()) known.push_back(each);
  }
  require(!known.empty(), table.file(), ": knows no runway of \"", airport, "\". Write the airport's ICAO code");
  throw InputError(concat(table.file(), ": \"", airport, "\" has no runway \"", runway, "\". It has: ", joined(known)));
}

Site site_of(const RunwayEnd& end, double safety_length, double safety_width, double minimum_setback) {
  Site site;
  site.name = concat(end.name, end.name == end.airport ? "" : concat(" (", end.airport, ")"), ", runway ", end.runway,
                     ", overrun of the end ", end.opposite);
  site.source =
      fmt::format("{}; its coordinates tell {:.2g} m apart; safety area as given", end.source, end.resolution);
  site.end = end.end, site.heading = end.heading;
  site.runway_width = end.width, site.elevation = end.elevation, site.displaced_threshold = end.displaced_threshold;
  site.safety_length = safety_length, site.safety_width = safety_width, site.minimum_setback = minimum_setback;
  return site;
}

}  // namespace apc::site
