#include "sph_backend/deck_json.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "apc/base/require.h"
#include "apc/base/units.h"
#include "sph_backend/material_json.h"

namespace apc::sph {
namespace {

bool is_object(const Json& file, const char* key) { return file.has(key) && file.raw().at(key).is_object(); }

WheelSpin read_spin(const Json& file) {
  const std::string word = file.text("spin", "free");
  file.check(word == "free" || word == "driven" || word == "locked", "spin", "is none of free, driven and locked.");
  return word == "driven" ? WheelSpin::driven : word == "locked" ? WheelSpin::locked : WheelSpin::free;
}

void check_case(const Json& file, const RollingCase& c) {
  using units::in;
  const auto inches = [](double length) { return concat(length / in, " in"); };
  file.check(c.speed > 0.0, "speed", "must be positive: the tire rolls forward.");
  file.check(c.speed < 200.0, "speed", "is beyond 200 m/s. Write e.g. \"70 kt\".");
  file.check(c.bed_depth > 0.0, "bed_depth", "must be positive. Give the depth of foam above the rigid plane.");
  file.check(c.spacing > 0.0, "spacing", "must be positive. Leave it out for the recommended one.");
  file.check(c.bed_depth >= 3.999 * c.spacing, file.has("spacing") ? "spacing" : "bed_depth",
             concat("makes the bed thinner than four particles (", inches(c.bed_depth), " at ", inches(c.spacing),
                    "). Use at most ", inches(c.bed_depth / 4.0), "."));
  file.check(c.spacing <= 0.25 * c.tire.width, "spacing",
             concat("gives fewer than four particles across the tire's ", inches(c.tire.width), ". Use at most ",
                    inches(0.25 * c.tire.width), "."));
  file.check(c.penetration > 0.0, "penetration", "must be positive.");
  file.check(c.penetration <= c.tire.diameter, "penetration",
             concat("is more than the tire's diameter, ", inches(c.tire.diameter), "."));
  const double deepest = maximum_penetration(c.tire, c.bed_depth);
  file.check(c.penetration <= 1.1 * deepest, "penetration",
             concat("is more than this tire can sink into this bed, ", inches(deepest),
                    " (0.85 of the depth and its deflection at 80 % of bottoming)."));
  file.check(c.friction >= 0.0 && c.friction <= 2.0, "friction", "must lie in [0, 2].");
  file.check(c.cfl > 0.0 && c.cfl <= 0.5, "cfl", "must lie in (0, 0.5]: beyond, the explicit step is unstable.");
  file.check(c.bed_half_width == 0.0 || c.bed_half_width > 0.5 * c.tire.width + 2.0 * c.spacing, "bed_half_width",
             concat("leaves less than two particles beside the tire. Use more than ",
                    inches(0.5 * c.tire.width + 2.0 * c.spacing), "."));
  file.check(c.release_spin_ratio >= 0.0 && c.release_spin_ratio <= 2.0, "release_spin_ratio", "must lie in [0, 2].");
}

}  // namespace

TireShape read_tire_shape(const Json& object) {
  using namespace dimension;
  TireShape t;
  t.name = object.text("name");
  object.text("source");
  t.diameter = object.quantity("diameter", length), t.width = object.quantity("width", length);
  t.rim_diameter = object.quantity("rim_diameter", length);
  t.inflation = object.quantity("inflation", pressure);
  t.rated_load = object.quantity("rated_load", force), t.rated_deflection = object.quantity("rated_deflection", length);
  t.bottoming_load = object.quantity("bottoming_load", force);
  t.bottoming_deflection = object.quantity("bottoming_deflection", length);
  for (const char* key : {"curve", "sources", "schema"}) object.ignore(key);
  object.check(t.rim_diameter > 0.0 && t.rim_diameter < t.diameter, "rim_diameter",
               "must lie between 0 and the diameter.");
  object.check(t.width > 0.0, "width", "must be positive.");
  object.check(t.inflation > 0.0, "inflation", "must be positive.");
  object.check(t.rated_load > 0.0 && t.rated_load < t.bottoming_load, "rated_load",
               "must lie between 0 and the bottoming load.");
  object.check(t.rated_deflection > 0.0 && t.rated_deflection < t.bottoming_deflection, "rated_deflection",
               "must lie between 0 and the bottoming deflection.");
  return t;
}

RollingCase read_deck(const Json& file, const DeckNames& names) {
  using namespace dimension;
  file.schema("apc-sph/1");
  file.text("source", "");
  file.text("name", "");
  RollingCase c;
  if (is_object(file, "tire")) {
    c.tire = read_tire_shape(file.object("tire"));
  } else {
    const std::string name = file.text("tire");
    file.check(static_cast<bool>(names.tire), "tire", "is a name; write the tire as an object here.");
    c.tire = names.tire(name);
  }
  if (is_object(file, "material")) {
    c.foam = read_foam(file.object("material")).foam;
  } else {
    const std::string name = file.text("material");
    file.check(static_cast<bool>(names.material), "material", "is a name; write the foam as an object here.");
    c.foam = load_foam(names.material(name)).foam;
  }
  c.bed_depth = file.quantity("bed_depth", length);
  c.penetration = file.quantity("penetration", length);
  c.speed = file.quantity("speed", speed);
  c.spacing = file.quantity("spacing", length, recommended_spacing(c.tire, c.bed_depth));
  c.friction = file.number("friction", c.friction);
  c.bed_half_width = file.quantity("bed_half_width", length, c.bed_half_width);
  c.outer_wall = file.flag("outer_wall", c.outer_wall);
  c.ahead = file.quantity("ahead", length, c.ahead), c.behind = file.quantity("behind", length, c.behind);
  c.press_speed = file.quantity("press_speed", speed, c.press_speed);
  c.accelerate_distance = file.quantity("accelerate_distance", length, c.accelerate_distance);
  c.entry = file.quantity("entry", length, c.entry);
  file.check(c.entry >= 0.0 && c.entry < 20.0, "entry",
             "must lie in [0, 20 m]: the way along which the wheel comes down.");
  c.spin = read_spin(file);
  c.fall = file.number("fall", c.fall);
  file.check(std::abs(c.fall) <= 0.1, "fall", "must lie in [-0.1, 0.1]: the wheel's way down per length of way.");
  c.release_spin_ratio = file.number("release_spin_ratio", c.release_spin_ratio);
  if (file.has("viscosity")) {
    const Json viscosity = file.object("viscosity");
    c.alpha = viscosity.number("alpha", c.alpha), c.beta = viscosity.number("beta", c.beta);
    viscosity.check(c.alpha >= 0.0 && c.alpha <= 5.0, "alpha", "must lie in [0, 5].");
    viscosity.check(c.beta >= 0.0 && c.beta <= 10.0, "beta", "must lie in [0, 10].");
    viscosity.finish();
  }
  c.cfl = file.number("cfl", c.cfl);
  c.longest = file.quantity("longest", length, c.longest);
  c.load_tolerance = file.number("load_tolerance", c.load_tolerance);
  c.spin_tolerance = file.number("spin_tolerance", c.spin_tolerance);
  check_case(file, c);
  file.finish();
  return c;
}

RollingCase load_deck(const std::filesystem::path& path, const DeckNames& names) {
  return read_deck(read_json(path), names);
}

}  // namespace apc::sph
