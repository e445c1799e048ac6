/// `apc site`: a runway end from a file or from an installed airport data set, a bed placed behind it, and drawings for
/// maps.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "apc/base/file.h"
#include "apc/base/require.h"
#include "apc/base/units.h"
#include "apc/cli/commands.h"
#include "apc/site/airports.h"

namespace apc::cli {
namespace {

namespace fs = std::filesystem;
using report::shown;
namespace measure = report::measure;

struct Words {
  std::string site, airport, runway, length, width, setback = "0 ft", bed;
  fs::path data, out;
};

double option_length(const std::string& option, const std::string& text, double low, double high) {
  const double value = option_quantity(option, text, dimension::length);
  require(value >= low && value <= high, option, ": \"", text, "\" is outside ", low, " to ", high, " m");
  return value;
}

site::Site site_from_set(const Words& words) {
  require(!words.runway.empty(), "--runway: is missing. Name the runway in use, such as 09: its far end is overrun");
  require(!words.length.empty() && !words.width.empty(),
          "--safety-length, --safety-width: are missing. The data set knows nothing of safety areas; give the space "
          "behind the pavement end, such as --safety-length \"1000 ft\" --safety-width \"500 ft\"");
  const auto end = site::find_runway_end(site::airport_folder(words.data), words.airport, words.runway);
  return site::site_of(end, option_length("--safety-length", words.length, 1.0, 2000.0),
                       option_length("--safety-width", words.width, end.width, 1000.0),
                       option_length("--minimum-setback", words.setback, 0.0, 1000.0));
}

std::string brief(const site::Site& site, report::UnitSystem units) {
  const auto distance = [&](double value) { return shown(value, measure::distance, units); };
  return fmt::format(
      "  {}\n  pavement end   {:.6f}, {:.6f} deg, overrun towards {:.2f} deg true; runway {} wide\n"
      "  safety area    {} long, {} wide; bed not before {}\n  source         {}\n",
      site.name, site.end.latitude / units::deg, site.end.longitude / units::deg, site.heading / units::deg,
      distance(site.runway_width), distance(site.safety_length), distance(site.safety_width),
      distance(site.minimum_setback), site.source);
}

void run_site(const Words& words, Settings& settings) {
  require(words.site.empty() != words.airport.empty(),
          "give either --site FILE or --airport CODE --runway NAME, to say which runway end is meant");
  const auto place =
      words.site.empty() ? site_from_set(words) : site::load_site(resolve(words.site, "designs/sites", "site"));
  std::vector<site::Check> checks;
  bed::Bed bed;
  if (!words.bed.empty()) {
    bed = bed::load_bed(resolve(words.bed, "designs/beds", "bed"));
    checks = site::fit(place, bed);
  }
  const auto folder = words.out.empty() ? fs::path("out") / "site" : words.out;
  write_text(folder / "site.json", site::site_json(place));
  if (!words.bed.empty()) {
    write_text(folder / "site.geojson", site::geojson(place, bed));
    write_text(folder / "site.kml", site::kml(place, bed));
  }
  if (!settings.json.empty()) write_text(settings.json, site::placing_json(place, checks));
  for (const auto& each : checks)
    if (!each.met) settings.exit_code = exit_code::not_met;
  if (settings.quiet) return;
  std::fputs(brief(place, settings.units).c_str(), stdout);
  for (const auto& each : checks) {
    std::printf("  %-4s           %s: %s against %s\n", each.met ? "fits" : "FAIL", each.what.c_str(),
                each.grade ? fmt::format("{:.4f}", each.value).c_str()
                           : shown(each.value, measure::distance, settings.units).c_str(),
                each.grade ? fmt::format("{:.4f}", each.limit).c_str()
                           : shown(each.limit, measure::distance, settings.units).c_str());
  }
  std::printf("  written        %s%s\n", (folder / "site.json").c_str(),
              words.bed.empty() ? "" : ", site.geojson and site.kml beside it");
}

}  // namespace

void add_site(CLI::App& program, Settings& settings) {
  auto* command = program.add_subcommand("site", "places a bed behind a runway end: fit, GeoJSON, KML");
  const auto words = std::make_shared<Words>();
  command->add_option("--site", words->site, "runway end (apc-site/1)")->type_name("NAME|FILE");
  command->add_option("--airport", words->airport, "ident, ICAO, IATA or local code in the installed data set")
      ->type_name("CODE");
  command->add_option("--runway", words->runway, "the runway in use, such as 09: its far end is overrun")
      ->type_name("NAME");
  command->add_option("--safety-length", words->length, "of the safety area behind the pavement end")
      ->type_name("LENGTH");
  command->add_option("--safety-width", words->width, "of the safety area")->type_name("LENGTH");
  command->add_option("--minimum-setback", words->setback, "of the bed from the pavement end (default \"0 ft\")")
      ->type_name("LENGTH");
  command
      ->add_option(
          "--data", words->data,
          "folder with runways.csv and airports.csv in the format of OurAirports (default: $APC_AIRPORTS, then "
          "share/apc/airports)")
      ->type_name("DIR");
  command->add_option("--bed", words->bed, "also place this bed: fit, site.geojson, site.kml")->type_name("NAME|FILE");
  command->add_option("-o,--out", words->out, "folder of the files (default out/site)")->type_name("DIR");
  add_common_options(*command, settings);
  command->footer(
      "Writes site.json for apc report --site. Exit code 1 when the bed does not fit.\n"
      "Example: apc site --site example_runway_end --bed emas_18in_50psi");
  command->callback([words, &settings] { run_site(*words, settings); });
}

}  // namespace apc::cli
