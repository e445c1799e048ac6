/// What lies before and after the motion of one overrun: the plant in trim at the leading edge with its observer, and
/// the result made from where it ended.
#pragma once

#include "apc/simulation/overrun_run.h"
#include "apc/simulation/trim.h"

namespace apc::simulation {

/// Stays where it is made (the observer points to the plant); model and overrun must outlive it.
struct Prepared {
  Prepared(const Model&, const Overrun&, const Options&);
  Prepared(const Prepared&) = delete;
  Prepared& operator=(const Prepared&) = delete;

  const Plant plant;
  const Trim start;
  Observer observer;
};

Result finish(const Model&, const Overrun&, const Options&, Prepared&, const Ending&);

/// × Options::rtol: the tolerance of the fast path's steps.
double fast_tolerance(const Plant&);
/// An effect changes aircraft or bed before the run: the model must be copied.
bool alters_site(const Overrun&);

}  // namespace apc::simulation
