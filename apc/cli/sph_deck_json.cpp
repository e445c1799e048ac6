#include <vector>

#include "aircraft/aircraft.h"
#include "apc/base/file.h"
#include "apc/base/json.h"
#include "apc/base/require.h"
#include "apc/base/units.h"
#include "apc/cli/inputs.h"
#include "apc/cli/sph_deck.h"
#include "sph_backend/material_json.h"

namespace apc::cli {
namespace {

namespace fs = std::filesystem;

sph::TireShape read_tire(const Json& deck, const fs::path& path, std::vector<report::InputFile>& files) {
  const auto name = deck.text("tire");
  const auto library = read_tires({}, path, files);
  const auto found = library.find(name);
  if (found == library.end()) {
    std::vector<std::string> known;
    for (const auto& [each, tire] : library) known.push_back(each);
    const auto near = nearest(name, known.data(), known.size());
    deck.refuse("tire", near.empty() ? "is not in the tire library (apc list tires)"
                                     : concat("is not in the tire library. Did you mean \"", near, "\"?"));
  }
  const auto& tire = found->second;
  return {tire.name,       tire.diameter,         tire.width,          tire.rim_diameter,        tire.inflation,
          tire.rated_load, tire.rated_deflection, tire.bottoming_load, tire.bottoming_deflection};
}

sph::Foam read_material(const Json& deck, const fs::path& path, std::vector<report::InputFile>& files) {
  const auto name = deck.text("material");
  std::error_code error;
  const auto beside = path.parent_path() / name;
  const auto file = fs::is_regular_file(beside, error) ? beside : resolve(name, "designs/materials", "material");
  const auto data = sph::load_foam(file);
  files.push_back(note("material", file, data.source));
  return data.foam;
}

/// An optional key with a range: outside it, a number is a slip.
double within(const Json& deck, const char* key, const Dimension& dimension, double otherwise, double low, double high,
              const char* why) {
  const double value = deck.quantity(key, dimension, otherwise);
  if (deck.has(key)) deck.check(value >= low && value <= high, key, why);
  return value;
}

}  // namespace

SphDeck read_deck(const fs::path& path) {
  const auto deck = read_json(path);
  deck.schema("apc-sph/1");
  SphDeck out;
  out.name = deck.text("name");
  out.source = deck.text("source");
  out.files.push_back(note("deck", path, out.source));
  auto& rig = out.rig;
  rig.tire = read_tire(deck, path, out.files);
  rig.foam = read_material(deck, path, out.files);
  out.material = rig.foam.name;
  rig.speed = deck.quantity("speed", dimension::speed);
  deck.check(rig.speed > 0.5 && rig.speed <= 120.0, "speed", "is not between 0.5 and 120 m/s, such as \"70 kt\"");
  rig.bed_depth = deck.quantity("bed_depth", dimension::length);
  deck.check(rig.bed_depth > 0.0 && rig.bed_depth <= 2.0, "bed_depth", "is no depth of a bed (above 0, at most 2 m)");
  rig.penetration = deck.quantity("penetration", dimension::length);
  const double deepest = sph::maximum_penetration(rig.tire, rig.bed_depth);
  deck.check(rig.penetration > 0.0 && rig.penetration <= 1.001 * deepest, "penetration",
             concat("is not between 0 and the largest for this tire and depth, ", deepest / units::in, " in"));
  rig.spacing = deck.quantity("spacing", dimension::length, sph::recommended_spacing(rig.tire, rig.bed_depth));
  deck.check(rig.spacing > 0.0 && rig.spacing <= 0.5 * rig.tire.width, "spacing",
             "does not resolve the tire. An eighth of its width is usual");
  rig.friction = within(deck, "friction", dimension::none, rig.friction, 0.0, 2.0, "is no friction coefficient");
  rig.bed_half_width = within(deck, "bed_half_width", dimension::length, rig.bed_half_width, 0.5 * rig.tire.width, 20.0,
                              "must be at least half the tire's width");
  rig.bed_margin = within(deck, "bed_margin", dimension::none, rig.bed_margin, 0.0, 20.0, "is not between 0 and 20");
  rig.outer_wall = deck.flag("outer_wall", rig.outer_wall);
  rig.alpha = within(deck, "alpha", dimension::none, rig.alpha, 0.0, 5.0, "is no artificial viscosity");
  rig.beta = within(deck, "beta", dimension::none, rig.beta, 0.0, 10.0, "is no artificial viscosity");
  rig.cfl = within(deck, "cfl", dimension::none, rig.cfl, 0.01, 0.6, "is not between 0.01 and 0.6");
  rig.window = within(deck, "window", dimension::length, rig.window, 0.01, 20.0, "is no averaging window");
  rig.longest = within(deck, "longest", dimension::length, rig.longest, 0.01, 200.0, "is no length of travel");
  deck.finish();
  return out;
}

}  // namespace apc::cli
