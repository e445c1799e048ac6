/// simulate() for callers on many threads who each wait for one overrun at a time (sweeps, searches, designs): what
/// they ask for at the same time runs side by side in lanes. Every result has the bits of simulate() alone.
#pragma once

#include <memory>

#include "apc/simulation/simulate.h"

namespace apc::simulation {

class Together {
 public:
  /// At most `convoys` threads compute at a time; 0 = as many as the machine has.
  explicit Together(unsigned convoys = 0);
  /// Waits until the overrun is done. While it waits the caller's thread may move a convoy on, its own run among
  /// others.
  Result operator()(const Model&, const Overrun&, const Options&) const;
  /// Callers that keep all lanes of all convoys busy.
  unsigned callers() const;

 private:
  struct Yard;
  std::shared_ptr<Yard> yard_;  ///< copies share it
};

}  // namespace apc::simulation
