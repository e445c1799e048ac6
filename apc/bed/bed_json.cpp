/// Schema "apc-bed/1", and what a bed must satisfy to be one.
#include <cctype>
#include <nlohmann/json.hpp>

#include "apc/base/json.h"
#include "apc/base/require.h"
#include "apc/base/units.h"
#include "apc/bed/bed.h"

namespace apc::bed {
namespace {

// Beyond these a number is a slip of unit or sign, not a design: beds built so far are under 1 m deep and 300 m long.
constexpr double deepest = 2.0 * units::m, longest = 2.0 * units::km, widest = 300.0 * units::m;

/// Refuses one element of a list of quantities by its own place: "bed.json /profile/depth/values/2: -18 is negative".
[[noreturn]] void refuse_element(const Json& object, const std::string& key, std::size_t index,
                                 const std::string& why) {
  const auto& list = object.raw()[key];
  const bool with_unit = list.is_object();
  const auto& value = with_unit ? list["values"][index] : list[index];
  throw InputError(concat(object.file(), " ", object.path(), "/", key, with_unit ? "/values/" : "/", index, ": ",
                          value.dump(), " ", why));
}

void read_profile(const Json& profile, Bed& bed) {
  bed.distance = profile.quantities("distance", dimension::length);
  bed.depth = profile.quantities("depth", dimension::length);
  const auto& distance = bed.distance;
  const auto& depth = bed.depth;
  profile.check(distance.size() == depth.size(), "depth",
                concat("has ", depth.size(), " values, but \"distance\" has ", distance.size(),
                       ". Give one depth for each distance"));
  profile.check(distance.size() >= 2, "distance",
                "is too short: a bed needs at least its leading edge and its far end, such as [0, 400]");
  if (distance.front() != 0.0)
    refuse_element(profile, "distance", 0,
                   "is not 0. Distances count from the bed's leading edge: start with 0 and put the free "
                   "runway before it into \"setback\"");
  for (std::size_t i = 1; i < distance.size(); ++i)
    if (distance[i] <= distance[i - 1])
      refuse_element(profile, "distance", i,
                     "does not increase over the value before it. Distances count from the leading edge and "
                     "must increase strictly; write a step as two distances a little apart");
  profile.check(bed.length() <= longest, "distance",
                concat("ends ", bed.length(), " m behind the leading edge, more than ", longest, " m. Check its unit"));
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (depth[i] < 0.0)
      refuse_element(profile, "depth", i, "is negative. Depth is the thickness of the material, 0 or more");
    if (depth[i] > deepest)
      refuse_element(profile, "depth", i,
                     concat("is ", depth[i], " m of material; no bed is deeper than ", deepest,
                            " m. Check the unit of \"depth\""));
  }
  profile.check(bed.maximum_depth() > 0.0, "depth", "is 0 everywhere: that is pavement, not a bed");
}

NominalMaterial read_nominal(const Json& json) {
  NominalMaterial nominal;
  nominal.strength = json.quantity("strength", dimension::pressure);
  nominal.density = json.quantity("density", dimension::density);
  nominal.bottoming_strain = json.number("bottoming_strain");
  json.check(nominal.strength > 0.0 && nominal.strength <= 10.0 * units::MPa, "strength",
             "is no crushing strength of a bed material. Expected between 0 and 10 MPa, such as \"50 psi\"");
  json.check(nominal.density > 0.0 && nominal.density <= 3000.0, "density",
             "is no density of a bed material. Expected between 0 and 3000 kg/m^3, such as \"320 kg/m^3\"");
  json.check(nominal.bottoming_strain > 0.0 && nominal.bottoming_strain < 1.0, "bottoming_strain",
             "is not between 0 and 1. It is the share of the volume that is lost when the material is fully "
             "compacted, such as 0.85");
  return nominal;
}

bool is_date(const std::string& text) {
  if (text.size() != 10 || text[4] != '-' || text[7] != '-') return false;
  for (const std::size_t i : {0, 1, 2, 3, 5, 6, 8, 9})
    if (!std::isdigit(static_cast<unsigned char>(text[i]))) return false;
  const int month = std::stoi(text.substr(5, 2)), day = std::stoi(text.substr(8, 2));
  return month >= 1 && month <= 12 && day >= 1 && day <= 31;
}

}  // namespace

Bed load_bed(const std::filesystem::path& path) { return read_bed(read_json(path)); }

Bed read_bed(const Json& json) {
  json.schema("apc-bed/1");
  Bed bed;
  bed.name = json.text("name");
  bed.source = json.text("source");
  bed.material = json.text("material");
  bed.setback = json.quantity("setback", dimension::length);
  json.check(bed.setback >= 0.0, "setback", "is negative. The bed begins at or behind the pavement end");
  json.check(bed.setback <= longest, "setback", concat("is more than ", longest, " m. Check its unit"));
  bed.width = json.quantity("width", dimension::length);
  json.check(bed.width > 0.0, "width", "is not positive. Give the bed's width across the runway, such as \"150 ft\"");
  json.check(bed.width <= widest, "width", concat("is more than ", widest, " m. Check its unit"));
  const auto flush = json.text("flush", "top");
  json.check(flush == "top" || flush == "base", "flush",
             "is unknown. Write \"top\" (surface level with the pavement) or \"base\" (base level with it)");
  bed.flush = flush == "base" ? Flush::base : Flush::top;
  read_profile(json.object("profile"), bed);
  if (json.has("blocks")) {
    const auto blocks = json.object("blocks");
    for (const auto& [key, value] : {std::pair{"length", &bed.block_length}, {"width", &bed.block_width}}) {
      *value = blocks.quantity(key, dimension::length);
      blocks.check(*value > 0.0, key, "is not positive. Leave \"blocks\" out for a bed cast in one piece");
    }
  }
  bed.grade = json.number("grade", 0.0);
  json.check(bed.grade >= -0.1 && bed.grade <= 0.1, "grade",
             "is steeper than 1 in 10. The grade is rise over run, such as 0.01 for one percent");
  if (json.has("nominal")) bed.nominal = read_nominal(json.object("nominal"));
  if (json.has("built")) {
    bed.built = json.text("built");
    json.check(is_date(bed.built), "built", "is not a date. Write year-month-day, such as \"2019-03-01\"");
  }
  json.finish();
  return bed;
}

}  // namespace apc::bed
