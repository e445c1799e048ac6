#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apc/base/units.h"
#include "apc/report/compliance_record.h"
#include "apc/report/svg.h"

namespace apc::report {

const char* text(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "pass";
    case Verdict::fail:
      return "fail";
    case Verdict::not_verified:
      return "not verified";
    default:
      return "not checked";
  }
}

namespace {

constexpr double standard_speed = 70 * units::kt, least_speed = 40 * units::kt, envelope = 600 * units::ft,
                 small_aircraft = 25000 * units::lb, friction = 0.25, usual_setback = 35 * units::ft,
                 undershoot = 600 * units::ft;

const char* const first_pages = "FAA AC 150/5220-22A/B, first pages, read";
const char* const recalled = "FAA AC 150/5220-22B as recalled; the clause was not read";

/// Collects findings; a recalled clause never becomes more than "not verified".
struct List {
  std::vector<Finding> all;
  void checked(const std::string& clause, const std::string& basis, bool read, bool met, const std::string& evidence) {
    const auto verdict = !met   ? (read ? Verdict::fail : Verdict::not_verified)
                         : read ? Verdict::pass
                                : Verdict::not_verified;
    all.push_back({clause, basis, read, verdict,
                   (read  ? ""
                    : met ? "As recalled it would be met: "
                          : "<b>As recalled it would not be met:</b> ") +
                       evidence});
  }
  void open(const std::string& clause, const std::string& basis, bool read, const std::string& why) {
    all.push_back(
        {clause, basis, read, read ? Verdict::not_checked : Verdict::not_verified, "Not checked here: " + why});
  }
};

std::string slowest(const ComplianceRecord& record, double ComplianceCase::*speed, double& value) {
  std::size_t at = 0;
  for (std::size_t k = 1; k < record.cases.size(); ++k)
    if (record.cases[k].*speed < record.cases[at].*speed) at = k;
  value = record.cases[at].*speed;
  const auto& each = record.design.fleet.cases[at];
  return escaped(each.aircraft + ", " + each.name) + " up to " + both(value, measure::speed);
}

void performance(const ComplianceRecord& record, List& list) {
  double arrested = 0.0, intact = 0.0;
  const auto arrest_text = slowest(record, &ComplianceCase::arrest_speed, arrested);
  const auto intact_text = slowest(record, &ComplianceCase::intact_speed, intact);
  list.checked("Standard bed: stops the design aircraft from an exit speed of 70 kt", first_pages, true,
               arrested >= standard_speed, "least of all cases: " + arrest_text);
  list.checked("Non-standard bed: stops from at least 40 kt",
               "FAA Order 5200.9 as quoted by a maker and in ACRP Report 29, p. 104, read", true,
               arrested >= least_speed, "least of all cases: " + arrest_text);
  list.checked("Stops by predictable decelerating forces on the landing gear, structural damage minimised",
               "AC 150/5220-22A as quoted in two secondary texts, read", true, intact >= least_speed,
               std::string("all known gear loads within their ") + study::text(record.design.fleet.limits.criterion) +
                   "s from at least 40 kt, whether or not the design counted them; least of all cases: " + intact_text);
  list.checked(
      "At 70 kt no load beyond the aircraft's design limits, no major damage, no excessive forces on occupants",
      recalled, false, intact >= standard_speed, "least of all cases: " + intact_text);
  bool asked = true, thrust = true, small = false;
  for (std::size_t k = 0; k < record.cases.size(); ++k) {
    const auto& run = record.design.fleet.cases[k].overrun;
    asked = asked && run.braking <= friction + 1e-9 && run.braking_in_bed <= friction + 1e-9;
    thrust = thrust && run.thrust >= 0;
    small = small || record.cases[k].result.mass < small_aircraft;
  }
  list.checked("Poor braking (friction 0.25 at most), no reverse thrust", recalled, false, asked && thrust,
               asked && thrust ? "all cases" : "a case brakes harder or reverses");
  list.checked("Beds may be ineffective for aircraft below 25,000 lb",
               "AC 150/5220-22 as quoted in a public encyclopaedia, read", true, !small,
               small ? "a case is lighter: treat its result with care" : "all cases are heavier");
  list.open("Designed for take-off weight and for 80 % of landing weight; lighter weights may need a longer bed",
            recalled, false, "the weights are those of the cases listed above");
  std::string planes;
  for (const auto& name : design::aircraft_names(record.design.fleet))
    planes += (planes.empty() ? "" : ", ") + escaped(name);
  list.open("The design aircraft is the most demanding regular user, or a composite of several", recalled, false,
            "which aircraft use this runway is not known here; the design counts " + planes);
  list.open("Predicted by a validated method, derived from tests of aircraft or of single wheels", recalled, false,
            "no arrestment of these aircraft in this bed was measured; what the prediction rests on is said below");
}

void geometry(const ComplianceRecord& record, List& list) {
  const auto& bed = record.design.bed;
  const double end = bed.setback + bed.length();
  list.checked("Ends within 600 ft of the runway end (the standard alternative to a full safety area)",
               "FAA fact sheet, 4 April 2014, read", true, end <= envelope + 1e-6,
               "the bed ends " + both(end, measure::distance) + " behind the pavement end");
  if (record.site) {
    for (const auto& check : record.fit)
      list.checked("Site: " + check.what, "the site's file: " + escaped(record.site->name), true, check.met,
                   check.grade
                       ? fmt::format("{:.4f} against {:.4f}", check.value, check.limit)
                       : both(check.value, measure::distance) + " against " + both(check.limit, measure::distance));
    const double before = record.site->safety_length + record.site->displaced_threshold;
    list.checked("600 ft of safety area before the threshold of landings the other way (otherwise not a standard bed)",
                 "an airport's draft assessment, a secondary text, read", true, before >= undershoot - 1e-6,
                 both(before, measure::distance) + " with " +
                     both(record.site->displaced_threshold, measure::distance) + " of displaced threshold");
    list.checked("At least as wide as the runway", recalled, false, bed.width >= record.site->runway_width - 1e-6,
                 both(bed.width, measure::distance) + " against " + both(record.site->runway_width, measure::distance));
  } else {
    list.open("Centred on the extended centreline behind the runway end, inside the safety area",
              "AC 150/5220-22A as quoted in a secondary text, read", true, "no site was given (--site FILE)");
    list.open("600 ft of safety area before the threshold of landings the other way (otherwise not a standard bed)",
              "an airport's draft assessment, a secondary text, read", true, "no site was given (--site FILE)");
    list.open("At least as wide as the runway", recalled, false, "no site was given (--site FILE)");
  }
  list.checked("Set-back of at least 35 ft", recalled, false, bed.setback >= usual_setback - 1e-6,
               "set-back " + both(bed.setback, measure::distance));
}

void construction(List& list) {
  const char* const no = "needs tests or documents that no simulation replaces";
  list.open("Material of selected strength that deforms reliably and predictably", first_pages, true, no);
  list.open("Service life of 20 years", "AC 150/5220-22A as quoted in a secondary text, read", true, no);
  list.open("Marked with yellow chevrons (AC 150/5340-1)", "Aeronautical Information Manual 2-3-14, read", true, no);
  list.open("Not a stopway: no credit in declared distances",
            "AC 150/5300-13A § 312 as quoted in a public encyclopaedia, read", true, "a matter of publication");
  list.open("The safety-area standard itself is neither modified nor waived; alternatives are looked at again",
            "FAA Order 5200.8 as quoted in AC 150/5220-22B, first page, read", true, "a matter of administration");
  for (const char* clause :
       {"Rebound of crushed material considered", "Base carries design aircraft and rescue vehicles in all weather",
        "Rescue vehicles get in and out; people leave safely", "Carries pedestrians for maintenance",
        "Touching down short in the bed causes no loss of control", "No ponding on or beside the bed",
        "Undamaged by expected jet blast", "Repairable to usable condition within 45 days",
        "Lights and navigation aids in it are frangible",
        "Resists water, ice, fuel, de-icers, sunlight and vermin; does not burn or spark",
        "Design submitted 45 days before bidding; quality and inspection programme"})
    list.open(clause, recalled, false, no);
}

}  // namespace

std::vector<Finding> findings(const ComplianceRecord& record) {
  List list;
  performance(record, list);
  geometry(record, list);
  construction(list);
  return list.all;
}

}  // namespace apc::report
