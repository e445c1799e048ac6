/// Foam compacts earlier than its data sheet says: bottoming strain instead of 0.85: the depth that can be crushed is ×
/// strain/0.85. Source: data sheets of glass foam: bottoming at 0.85 of the depth.
#include "apc/effects/catalogue.h"

namespace apc::effects {
namespace {

void act(const TireState&, Values q, TireChange& change) { change.depth *= q[0] / 0.85; }

}  // namespace

Effect lock_up() {
  Effect e;
  e.id = "lock_up";
  e.title = "foam compacts earlier than its data sheet says";
  e.law = "bottoming strain instead of 0.85: the depth that can be crushed is × strain/0.85";
  e.source = "data sheets of glass foam: bottoming at 0.85 of the depth";
  e.touches = "vertical load and rut, deep ruts only";
  e.confused_with = "depth_as_built";
  e.parameters = {{"strain", "", dimension::none, 0.6, 0.95, 0.78, 0.85}};
  e.bed = act;
  return e;
}

}  // namespace apc::effects
