/// From probabilities of explanations to what is said: claims about effects, the set that holds 90 %, rivals, what
/// would have been seen, and the verdict.
#pragma once

#include "apc/learning/weighing.h"

namespace apc::learning {

/// An effect's probability is that of all explanations that hold it; its size that of the best one.
void make_claims(const Background&, const FamilyWise&, const std::vector<Single>&, double temper, Diagnosis&);
/// The most probable sets of effects that together hold 90 %, four at most.
void make_set90(Diagnosis&);
/// Leading effects that look alike.
void make_rivals(const Screen&, const std::vector<Single>&, Diagnosis&);
/// Sizes that would have been found with a power of 90 %.
void make_smallest(const Screen&, const std::vector<Single>&, const FamilyWise&, Diagnosis&);
/// The verdict, and the effects that a model would take from it. `along`: weighed along the measured motion.
void decide(Diagnosis&, bool along);

}  // namespace apc::learning
