#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "apc/base/require.h"
#include "apc/base/units.h"
#include "apc/site/site.h"

namespace apc::site {

Site read_site(const Json& json) {
  json.schema("apc-site/1");
  Site site;
  site.name = json.text("name");
  site.source = json.text("source");
  const auto end = json.object("runway_end");
  site.end.latitude = end.quantity("latitude", dimension::angle);
  end.check(std::abs(site.end.latitude) < 89 * units::deg, "latitude",
            "is no latitude of a runway: write degrees, such as \"40.6 deg\"");
  site.end.longitude = end.quantity("longitude", dimension::angle);
  end.check(std::abs(site.end.longitude) <= std::numbers::pi, "longitude", "is outside −180 to 180 degrees");
  site.heading = end.quantity("true_heading", dimension::angle);
  end.check(site.heading >= 0 && site.heading <= 2 * std::numbers::pi, "true_heading",
            "is outside 0 to 360 degrees: the direction in which aircraft overrun this end, from true north");
  site.runway_width = end.quantity("width", dimension::length);
  end.check(site.runway_width > 0 && site.runway_width <= 150, "width", "is no width of a runway");
  const auto area = json.object("safety_area");
  site.safety_length = area.quantity("length", dimension::length);
  area.check(site.safety_length > 0 && site.safety_length <= 2000, "length", "is no length of a safety area");
  site.safety_width = area.quantity("width", dimension::length);
  area.check(site.safety_width >= site.runway_width && site.safety_width <= 1000, "width",
             "is narrower than the runway, or no width of a safety area");
  site.minimum_setback = json.quantity("minimum_setback", dimension::length, 0.0);
  json.check(site.minimum_setback >= 0, "minimum_setback", "is negative");
  json.check(site.minimum_setback < site.safety_length, "minimum_setback",
             "leaves no room: the safety area ends before a bed could begin. Check both lengths");
  site.grade = json.number("grade", 0.0);
  json.check(std::abs(site.grade) <= 0.1, "grade", "is steeper than 1 in 10: write rise over run, such as -0.005");
  site.elevation = json.quantity("elevation", dimension::length, 0.0);
  json.check(std::abs(site.elevation) <= 5000, "elevation", "is no elevation of a runway. Check its unit");
  site.displaced_threshold = json.quantity("displaced_threshold", dimension::length, 0.0);
  json.check(site.displaced_threshold >= 0 && site.displaced_threshold <= 3000, "displaced_threshold",
             "is no distance from the pavement end back to a landing threshold (0 to 3000 m)");
  json.finish();
  return site;
}

std::string site_json(const Site& site) {
  const auto metres = [](double length) { return fmt::format("{:.3f} m", length); };
  const auto degrees = [](double angle) { return fmt::format("{:.9f} deg", angle / units::deg); };
  const nlohmann::ordered_json out{
      {"schema", "apc-site/1"},
      {"name", site.name},
      {"source", site.source},
      {"runway_end",
       {{"latitude", degrees(site.end.latitude)},
        {"longitude", degrees(site.end.longitude)},
        {"true_heading", degrees(site.heading)},
        {"width", metres(site.runway_width)}}},
      {"safety_area", {{"length", metres(site.safety_length)}, {"width", metres(site.safety_width)}}},
      {"minimum_setback", metres(site.minimum_setback)},
      {"grade", site.grade},
      {"elevation", metres(site.elevation)},
      {"displaced_threshold", metres(site.displaced_threshold)}};
  return out.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

Site load_site(const std::filesystem::path& path) { return read_site(read_json(path)); }

std::string placing_json(const Site& site, const std::vector<Check>& checks) {
  nlohmann::ordered_json out{{"schema", "apc-placing/1"},
                             {"site", nlohmann::ordered_json::parse(site_json(site))},
                             {"checks", nlohmann::ordered_json::array()}};
  for (const auto& each : checks)
    out["checks"].push_back({{"what", each.what}, {"value", each.value}, {"limit", each.limit}, {"met", each.met}});
  return out.dump(1) + "\n";
}

}  // namespace apc::site
