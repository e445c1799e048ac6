#include "apc/simulation/neighbours.h"

#include "apc/simulation/overrun_run.h"
#include "apc/simulation/trim.h"

namespace apc::simulation {

Variant::Variant(const Model& base, const Overrun& run, const ScalarParameter& parameter, double amount)
    : model(base), overrun(run) {
  if (amount != 0.0) parameter.shift(model, overrun, amount);
  effects::Site site{
      model.aircraft, model.bed, overrun.mass > 0.0 ? overrun.mass : model.aircraft.mass,
      overrun.cg_behind_nose_gear > 0.0 ? overrun.cg_behind_nose_gear : model.aircraft.cg_behind_nose_gear};
  effects::alter_site(overrun.alterations, site);
  overrun.headwind += site.headwind;
  plant = make_plant(model, overrun);
  around = surroundings_at_entry(plant);
  start = trim(plant, overrun.entry_speed).state;
}

Neighbours::Neighbours(const Model& model, const Overrun& overrun, const ScalarParameter& parameter)
    : epsilon(parameter.step),
      base(model, overrun, parameter, 0.0),
      up(model, overrun, parameter, parameter.step),
      down(model, overrun, parameter, -parameter.step) {}

}  // namespace apc::simulation
