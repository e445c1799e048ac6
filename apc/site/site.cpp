#include "apc/site/site.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "apc/base/markup.h"
#include "apc/base/require.h"
#include "apc/base/units.h"

namespace apc::site {
namespace {

constexpr double right_angle = std::numbers::pi / 2;

Place at(const Site& site, double along, double left) {
  const auto on_line = away(site.end, site.heading, along);
  return left == 0 ? on_line : away(on_line, site.heading - right_angle, left);
}

}  // namespace

Corners area(const Site& site, double from, double to, double width) {
  return {at(site, from, 0.5 * width), at(site, from, -0.5 * width), at(site, to, -0.5 * width),
          at(site, to, 0.5 * width)};
}

std::vector<Check> fit(const Site& site, const bed::Bed& bed) {
  require(bed.setback < site.safety_length, "site \"", site.name, "\" /safety_area/length: ", site.safety_length,
          " m is shorter than the bed's set-back of ", bed.setback,
          " m, so no part of the bed lies on it. Check both lengths, or design a bed with a smaller set-back");
  const double slack = 1e-6;
  std::vector<Check> out;
  const auto at_most = [&](const char* what, double value, double limit) {
    out.push_back({what, value, limit, value <= limit + slack, false});
  };
  const auto at_least = [&](const char* what, double value, double limit) {
    out.push_back({what, value, limit, value >= limit - slack, false});
  };
  at_least("set-back from the pavement end", bed.setback, site.minimum_setback);
  at_most("far end of the bed, within the safety area's length", bed.setback + bed.length(), site.safety_length);
  at_most("width of the bed, within the safety area's width", bed.width, site.safety_width);
  at_least("width of the bed, not below the runway's", bed.width, site.runway_width);
  out.push_back({"grade the bed was designed for, that of the site", bed.grade, site.grade,
                 std::abs(bed.grade - site.grade) <= 5e-3, true});
  return out;
}

namespace {

/// The closed ring of the corners. Longitudes go on beyond 180° where the ring crosses it: a jump to −180° would wind
/// the ring around the earth.
std::string text_of(const Corners& corners, const char* separator, const char* form) {
  std::string out;
  for (std::size_t i = 0; i <= corners.size(); ++i) {
    const auto& corner = corners[i % corners.size()];
    const double longitude =
        corners[0].longitude + std::remainder(corner.longitude - corners[0].longitude, 2 * std::numbers::pi);
    out += (i ? separator : "") + fmt::format(fmt::runtime(form), longitude / units::deg, corner.latitude / units::deg);
  }
  return out;
}

std::string quoted(const std::string& text) {
  std::string out;
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') out += '\\';
    out += static_cast<unsigned char>(letter) < 32 ? ' ' : letter;
  }
  return "\"" + out + "\"";
}

/// Pieces of the bed between the corners of its profile, with their depths.
struct Piece {
  Corners corners;
  double from, to, depth_from, depth_to;
};

std::vector<Piece> pieces(const Site& site, const bed::Bed& bed) {
  std::vector<Piece> out;
  for (std::size_t i = 0; i + 1 < bed.distance.size(); ++i)
    out.push_back({area(site, bed.setback + bed.distance[i], bed.setback + bed.distance[i + 1], bed.width),
                   bed.distance[i], bed.distance[i + 1], bed.depth[i], bed.depth[i + 1]});
  return out;
}

}  // namespace

std::string geojson(const Site& site, const bed::Bed& bed) {
  std::string features;
  const auto polygon = [&](const std::string& name, const Corners& corners, const std::string& more) {
    features += (features.empty() ? "" : ",\n") +
                fmt::format(
                    "{{\"type\":\"Feature\",\"properties\":{{\"name\":{}{}}},\"geometry\":{{\"type\":\"Polygon\","
                    "\"coordinates\":[[{}]]}}}}",
                    quoted(name), more, text_of(corners, ",", "[{:.9f},{:.9f}]"));
  };
  polygon("safety area", area(site, 0, site.safety_length, site.safety_width), "");
  polygon("set-back", area(site, 0, bed.setback, bed.width), fmt::format(",\"length_m\":{:.3f}", bed.setback));
  polygon("arrestor bed", area(site, bed.setback, bed.setback + bed.length(), bed.width),
          fmt::format(",\"bed\":{},\"length_m\":{:.3f},\"width_m\":{:.3f},\"material\":{}", quoted(bed.name),
                      bed.length(), bed.width, quoted(bed.material)));
  for (const auto& piece : pieces(site, bed))
    polygon("depth", piece.corners,
            fmt::format(",\"from_m\":{:.3f},\"to_m\":{:.3f},\"depth_from_m\":{:.4f},\"depth_to_m\":{:.4f}", piece.from,
                        piece.to, piece.depth_from, piece.depth_to));
  features += fmt::format(
      ",\n{{\"type\":\"Feature\",\"properties\":{{\"name\":\"pavement end\",\"site\":{}}},\"geometry\":{{\"type\":"
      "\"Point\",\"coordinates\":[{:.9f},{:.9f}]}}}}",
      quoted(site.name), site.end.longitude / units::deg, site.end.latitude / units::deg);
  return "{\"type\":\"FeatureCollection\",\"features\":[\n" + features + "\n]}\n";
}

std::string kml(const Site& site, const bed::Bed& bed) {
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document><name>" +
      escaped(site.name) + "</name>\n";
  const auto polygon = [&](const std::string& name, const char* colour, const Corners& corners) {
    out += fmt::format(
        "<Placemark><name>{}</name><Style><LineStyle><color>ff{}</color><width>2</width></"
        "LineStyle><PolyStyle><color>66{}"
        "</color></PolyStyle></Style><Polygon><outerBoundaryIs><LinearRing><coordinates>{}</coordinates></LinearRing>"
        "</outerBoundaryIs></Polygon></Placemark>\n",
        escaped(name), colour, colour, text_of(corners, " ", "{:.9f},{:.9f},0"));
  };
  polygon("safety area", "a0a0a0", area(site, 0, site.safety_length, site.safety_width));  // colours are blue-green-red
  polygon(fmt::format("arrestor bed, {:.1f} m", bed.length()), "78a8b9",
          area(site, bed.setback, bed.setback + bed.length(), bed.width));
  return out + fmt::format(
                   "<Placemark><name>pavement "
                   "end</name><Point><coordinates>{:.9f},{:.9f},0</coordinates></Point></Placemark>\n"
                   "</Document></kml>\n",
                   site.end.longitude / units::deg, site.end.latitude / units::deg);
}

}  // namespace apc::site
