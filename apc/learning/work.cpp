#include <cmath>

#include "apc/base/units.h"
#include "apc/learning/diagnose.h"

namespace apc::learning {
namespace {

/// Extra longitudinal force of an effect at one instant of a fitted motion, N against the motion.
double tire_force(const Background& b, const simulation::Overrun& plain, const effects::Applied& effect,
                  const simulation::History& h, std::size_t i) {
  effects::Alterations with = plain.alterations;
  with.effects.push_back(effect);
  double sum = 0.0;
  for (std::size_t g = 0; g < b.data->aircraft.gears.size(); ++g) {
    const aircraft::Gear& gear = b.data->aircraft.gears[g];
    const aircraft::Tire& tire = b.data->aircraft.tires.at(gear.tire);
    const effects::TireFacts facts{
        g,          gear.is_nose(), gear.wheels(),
        tire.width, tire.radius(),  b.data->bed.nominal ? b.data->bed.nominal->density : 320.0};
    const effects::TirePlace place{{h.speed[i], h.gears[g].bed_depth[i], h.gears[g].penetration[i]},
                                   h.gears[g].distance[i],
                                   h.distance[i],
                                   h.time[i]};
    sum += gear.wheels() * (effects::load(b.data->tables[g], with, facts, place).drag -
                            effects::load(b.data->tables[g], plain.alterations, facts, place).drag);
  }
  return sum;
}

}  // namespace

double work_of(const Background& b, std::size_t r, const effects::Applied& effect) {
  const simulation::History& h = b.traces[r].result.history;
  simulation::Overrun plain = overrun_of(*b.data, b.layout, r, b.runs[r], b.eta, b.added);
  std::erase_if(plain.alterations.effects, [&](const effects::Applied& a) { return a.effect.id == effect.effect.id; });
  aircraft::Aircraft craft = b.data->aircraft;
  bed::Bed bed = b.data->bed;
  const double area = craft.aero.CD * craft.aero.area;
  if (effect.effect.site) {
    effects::Site site{craft, bed, plain.mass, plain.cg_behind_nose_gear};
    effect.effect.site(site, effect.values);
  }
  const double grade = bed.grade - b.data->bed.grade, drag_area = craft.aero.CD * craft.aero.area - area;
  double work = 0.0, force = 0.0;
  for (std::size_t i = 0; i < h.time.size(); ++i) {
    if (h.time[i] < 0.0) continue;
    double now = plain.mass * units::g0 * grade + 0.5 * 1.225 * drag_area * std::pow(h.speed[i] + plain.headwind, 2);
    if (effect.effect.bed || effect.effect.force) now += tire_force(b, plain, effect, h, i);
    if (effect.effect.thrust) now -= effect.effect.thrust(h.time[i], effect.values);
    if (i > 0 && h.time[i - 1] >= 0.0) work += 0.5 * (now + force) * (h.distance[i] - h.distance[i - 1]);
    force = now;
  }
  if (effect.effect.id == "oleo_friction") {  // no force along the runway of its own: the energy its friction takes
    for (std::size_t g = 0; g < craft.gears.size(); ++g) {
      const double friction =
          (craft.gears[g].strut.friction - b.data->aircraft.gears[g].strut.friction) * craft.gears[g].struts;
      for (std::size_t i = 1; i < h.time.size(); ++i) {
        if (h.time[i] < 0.0) continue;
        const double rate = h.gears[g].stroke_rate[i];
        work += friction * std::abs(rate * std::tanh(rate / 0.02)) * (h.time[i] - h.time[i - 1]);
      }
    }
  }
  return work;
}

}  // namespace apc::learning
