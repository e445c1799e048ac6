#include "apc/effects/other_forms.h"

namespace apc::effects {

const std::vector<Effect>& other_forms() {
  static const std::vector<Effect> forms = {softening_rows(),      inertial_limited(), thrust_held(), aero_wind(),
                                            depth_as_built_wave(), tire_loss_slow(),   rate_strain()};
  return forms;
}

std::string named(const Effect& effect) {
  return effect.form.empty() ? effect.id : effect.id + " (" + effect.form + ")";
}

}  // namespace apc::effects
