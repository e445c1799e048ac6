#include "apc/simulation/together.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <vector>

#include "apc/base/parallel.h"
#include "apc/simulation/convoy.h"

namespace apc::simulation {
namespace {

/// One caller's overrun.
struct Request {
  Errand errand;
  Outturn outturn;
  bool done = false;
};

}  // namespace

/// Requests wait by shape. A caller who waits takes a convoy, unless all are being moved, and moves it until its own
/// request is done; then it leaves the convoy to the next who waits.
struct Together::Yard {
  unsigned convoys = 1;
  std::mutex guard;
  std::condition_variable changed;
  std::map<Shape, std::deque<Request*>> waiting;
  std::vector<std::unique_ptr<Convoy>> parked;  ///< with or without runs in them
  unsigned moving = 0;

  /// A convoy that has work to do: under way if there is one, else of the shape most wait for. Null: nothing to do.
  std::unique_ptr<Convoy> take() {
    for (auto& each : parked)
      if (!each->empty()) return remove(each);
    const Shape* most = nullptr;
    std::size_t count = 0;
    for (const auto& [shape, requests] : waiting)
      if (requests.size() > count) most = &shape, count = requests.size();
    if (!most) return nullptr;
    for (auto& each : parked)
      if (each->shape() == *most) return remove(each);
    return std::make_unique<Convoy>(*most);
  }
  std::unique_ptr<Convoy> remove(std::unique_ptr<Convoy>& place) {
    std::swap(place, parked.back());
    auto convoy = std::move(parked.back());
    parked.pop_back();
    return convoy;
  }

  /// Moves a convoy until `own` is done or nothing is left to do; called and left with the guard locked.
  void move(std::unique_ptr<Convoy> convoy, const Request& own, std::unique_lock<std::mutex>& lock) {
    ++moving;
    std::vector<Request*> joining;
    for (;;) {
      auto& queue = waiting[convoy->shape()];
      while (!queue.empty() && convoy->running() + joining.size() < convoy->width())
        joining.push_back(queue.front()), queue.pop_front();
      if (joining.empty() && convoy->empty()) break;
      lock.unlock();
      for (auto* request : joining) convoy->add(request->errand, reinterpret_cast<std::size_t>(request));
      joining.clear();
      convoy->advance();
      auto settled = convoy->settled();
      lock.lock();
      for (auto& each : settled) {
        auto* request = reinterpret_cast<Request*>(each.ticket);
        request->outturn = std::move(each.outturn);
        request->done = true;
      }
      if (!settled.empty()) changed.notify_all();
      if (own.done) break;
    }
    --moving;
    parked.push_back(std::move(convoy));
    changed.notify_all();
  }
};

Together::Together(unsigned convoys) : yard_(std::make_shared<Yard>()) {
  yard_->convoys = convoys == 0 ? hardware_threads() : convoys;
}

unsigned Together::callers() const { return yard_->convoys * (lanes_of_this_processor() + 2); }

Result Together::operator()(const Model& model, const Overrun& overrun, const Options& options) const {
  Request own{{&model, &overrun, &options}, {}, false};
  if (!fits_lanes(own.errand)) return simulate(model, overrun, options);
  auto& yard = *yard_;
  std::unique_lock lock(yard.guard);
  yard.waiting[shape_of(model, overrun)].push_back(&own);
  while (!own.done) {
    auto convoy = yard.moving < yard.convoys ? yard.take() : nullptr;
    if (convoy)
      yard.move(std::move(convoy), own, lock);
    else
      yard.changed.wait(lock);
  }
  lock.unlock();
  if (own.outturn.failure) std::rethrow_exception(own.outturn.failure);
  return std::move(own.outturn.result);
}

}  // namespace apc::simulation
