#include "apc/simulation/simulate_each.h"

#include <atomic>
#include <map>

#include "apc/base/parallel.h"
#include "apc/base/require.h"

namespace apc::simulation {
namespace {

Outturn alone(const Errand& errand) {
  try {
    return {simulate(*errand.model, *errand.overrun, *errand.options), nullptr};
  } catch (...) {
    return {{}, std::current_exception()};
  }
}

/// Errands of one shape, taken one by one by whoever has room.
struct Queue {
  std::vector<std::size_t> errands;
  std::atomic<std::size_t> next{0};
};

}  // namespace

std::vector<Outturn> simulate_each(std::span<const Errand> errands, unsigned threads) {
  std::vector<Outturn> outturns(errands.size());
  std::map<Shape, Queue> queues;
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < errands.size(); ++i) {
    if (fits_lanes(errands[i]))
      queues[shape_of(*errands[i].model, *errands[i].overrun)].errands.push_back(i);
    else
      others.push_back(i);
  }
  const unsigned crew = threads == 0 ? hardware_threads() : threads;
  parallel_for(others.size(), crew, [&](std::size_t i) { outturns[others[i]] = alone(errands[others[i]]); });
  for (auto& [shape, queue] : queues)
    parallel_for(crew, crew, [&, shape = shape](std::size_t) {
      Convoy convoy(shape);
      for (bool more = true; more || !convoy.empty();) {
        while (more && convoy.has_room()) {
          const auto place = queue.next++;
          more = place < queue.errands.size();
          if (more) convoy.add(errands[queue.errands[place]], queue.errands[place]);
        }
        convoy.advance();
        for (auto& each : convoy.settled()) outturns[each.ticket] = std::move(each.outturn);
      }
    });
  return outturns;
}

}  // namespace apc::simulation
