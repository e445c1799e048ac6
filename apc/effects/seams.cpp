/// Joints between blocks: strength × (1 − depth · ½(1 + cos(π r/width))) within width of a joint; joints at offset + n
/// pitch. Source: ACRP Report 29, pendulum tests: pulses at block seams.
#include <cmath>
#include <numbers>

#include "apc/effects/catalogue.h"

namespace apc::effects {
namespace {

void act(const TireState& state, Values q, TireChange& change) {
  const double place = state.bed_distance - q[3];
  const double r = std::abs(place - q[1] * std::round(place / q[1]));
  if (r < q[2] && state.bed_distance > 0.0)
    change.strength *= 1.0 - q[0] * 0.5 * (1.0 + std::cos(std::numbers::pi * r / q[2]));
}

}  // namespace

Effect seams() {
  Effect e;
  e.id = "seams";
  e.title = "joints between blocks";
  e.law = "strength × (1 − depth · ½(1 + cos(π r/width))) within width of a joint; joints at offset + n pitch";
  e.source = "ACRP Report 29, pendulum tests: pulses at block seams";
  e.touches = "line at v/pitch in all accelerations, fixed in space";
  e.confused_with = "block_scatter";
  e.parameters = {{"depth", "", dimension::none, 0.0, 0.6, 0.3, 0.0},
                  {"pitch", "m", dimension::length, 0.6, 2.5, 1.2192, 0.0},
                  {"width", "m", dimension::length, 0.03, 0.3, 0.1, 0.0},
                  {"offset", "m", dimension::length, 0.0, 2.5, 0.0, 0.0}};
  e.bed = act;
  e.fine = true;
  return e;
}

}  // namespace apc::effects
