#include "apc/effects/catalogue.h"

#include <algorithm>

#include "apc/base/require.h"

namespace apc::effects {

Applied applied(const Effect& effect, double amplitude) {
  Applied result{effect, {}};
  for (const Parameter& parameter : effect.parameters) result.values.push_back(parameter.usual);
  result.values.front() = amplitude;
  return result;
}

const std::vector<Effect>& catalogue() {
  static const std::vector<Effect> effects = {inertial(),    rate(),      seams(),          softening(),       ageing(),
                                              temperature(), wall_tear(), adhesion(),       rubble_friction(), debris(),
                                              cover(),       lock_up(),   depth_as_built(), slope(),           aero(),
                                              thrust(),      tire_loss(), oleo_friction()};
  return effects;
}

const Effect& find_effect(const std::vector<Effect>& effects, const std::string& id) {
  const auto found = std::find_if(effects.begin(), effects.end(), [&](const Effect& e) { return e.id == id; });
  if (found != effects.end()) return *found;
  std::vector<std::string> ids;
  for (const Effect& e : effects) ids.push_back(e.id);
  const std::string near = nearest(id, ids.data(), ids.size());
  throw InputError(concat("effect ", id, ": there is no such effect. ",
                          near.empty() ? std::string("'apc effects list' shows them.") : "Did you mean " + near + "?"));
}

}  // namespace apc::effects
