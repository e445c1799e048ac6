/// What a diagnosis adds to the model. Claimed effects get the sizes that free runs have them with, the strength fitted
/// beside them. Where nothing is claimed and yet something else than "nothing" is likely, two effects are tried — the
/// likeliest, and the one that mends free runs most, if two to one speaks for it — and the better is kept if runs left
/// out become better by it. Not tried: what knows a run by its date alone; sizes outside their range. Claims that do
/// not help runs left out keep a probability of 0.75 at most (joints excepted).
#pragma once

#include "apc/learning/diagnose.h"

namespace apc::learning {

/// Fills `strength`, `held_out`, and sizes of `diagnosis.augmented` (or what was tried); claims and verdict by what
/// runs left out say. Needs `free`; sizes and strength stay where a fit cannot be simulated.
void augment(Study&);

}  // namespace apc::learning
