#include "apc/simulation/sensitivity.h"

namespace apc::simulation::parameters {
namespace {

double mass_of(const Model& model, const Overrun& overrun) {
  return overrun.mass > 0.0 ? overrun.mass : model.aircraft.mass;
}

}  // namespace

ScalarParameter entry_speed() {
  return {"entry_speed", "m/s", 1e-5, 30.0, [](Model&, Overrun& o, double d) { o.entry_speed += d; }};
}
ScalarParameter mass() {  // the file's inertia scales with it, as in a run
  return {"mass", "kg", 0.5, 5e4, [](Model& m, Overrun& o, double d) { o.mass = mass_of(m, o) + d; }};
}
ScalarParameter cg_behind_nose_gear() {
  return {"cg_behind_nose_gear", "m", 1e-5, 10.0, [](Model& m, Overrun& o, double d) {
            o.cg_behind_nose_gear =
                (o.cg_behind_nose_gear > 0.0 ? o.cg_behind_nose_gear : m.aircraft.cg_behind_nose_gear) + d;
          }};
}
ScalarParameter pitch_inertia() {
  return {"pitch_inertia", "kg m^2", 20.0, 3e6, [](Model& m, Overrun& o, double d) {
            const double own = m.aircraft.pitch_inertia * mass_of(m, o) / m.aircraft.mass;
            o.pitch_inertia = (o.pitch_inertia > 0.0 ? o.pitch_inertia : own) + d;
          }};
}
ScalarParameter braking() {  // before the bed and, unless given its own value, inside
  return {"braking", "1", 1e-6, 0.3, [](Model&, Overrun& o, double d) { o.braking += d; }};
}
ScalarParameter thrust() {
  return {"thrust", "N", 1.0, 5e4, [](Model&, Overrun& o, double d) { o.thrust += d; }};
}
ScalarParameter headwind() {
  return {"headwind", "m/s", 1e-4, 10.0, [](Model&, Overrun& o, double d) { o.headwind += d; }};
}
ScalarParameter bed_depth() {
  return {"bed_depth", "1", 1e-6, 1.0, [](Model&, Overrun& o, double d) { o.bed_depth += d; }};
}
ScalarParameter bed_strength() {  // the altered balance is solved to 1e-9, hence the wider step
  return {"bed_strength", "1", 1e-3, 1.0, [](Model&, Overrun& o, double d) { o.alterations.bed_strength += d; }};
}
ScalarParameter grade() {
  return {"grade", "1", 1e-6, 0.02, [](Model& m, Overrun&, double d) { m.bed.grade += d; }};
}

std::vector<ScalarParameter> all() {
  return {entry_speed(), mass(),     cg_behind_nose_gear(), pitch_inertia(), braking(),
          thrust(),      headwind(), bed_depth(),           bed_strength(),  grade()};
}

}  // namespace apc::simulation::parameters
