/// The press's loop, for any block of foam that drifts, finds its forces and kicks: particles or elements.
///
/// A block offers, found by its arguments' namespace: next_step(b), drift(b), find_forces(b), contact_points(b),
/// stretches(b) (null without radius), push(b, i, fx, fy, fz), kick(b), is_broken(b), book_energy(b, result).
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>

#include "sph_backend/press_rig.h"
#include "sph_backend/press_tool.h"

namespace apc::sph {

template <class Block>
void press_block(const PressCase& given, Block& block, double area, PressResult& result) {
  const auto begin = std::chrono::steady_clock::now();
  PressTool tool;
  tool.height = given.depth;
  if (given.punch_half_width > 0.0) tool.half_width = given.punch_half_width;
  std::vector<float> stretch_before;
  const double ramp_time = 2.0 * 0.05 * given.depth / given.speed;
  double work = 0.0, direction = 1.0;
  bool turned = false;
  double reached = 0.0;  // strain of the last step
  const auto note = [&] {
    result.strain.push_back(reached), result.force.push_back(tool.force), result.work.push_back(work);
    result.clock.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    result.work_exact.push_back(area * given.depth * crush_work(given.foam, std::max(0.0, reached)));
  };
  for (long step = 1;; ++step) {
    // Smooth start, and a smooth turn when unloading is asked for.
    const double dt = next_step(block), target = direction * given.speed, most = given.speed * dt / ramp_time;
    tool.speed += std::clamp(target - tool.speed, -most, most);
    tool.height -= dt * tool.speed;
    const double strain = 1.0 - tool.height / given.depth;
    if (!turned && strain >= given.strain_end) {
      if (given.unload_to < 0.0) break;
      turned = true, direction = -0.2;
    }
    if (turned && tool.speed < 0.0 && strain <= given.unload_to) break;
    drift(block);
    if (const auto* now = stretches(block)) stretch_before = *now;
    find_forces(block);
    if (is_broken(block)) {
      result.inverted = true;
      break;
    }
    const ContactPoints points = contact_points(block);
    find_contact(points, tool, stretch_before.empty() ? nullptr : stretch_before.data());
    for (const auto& t : tool.touches) push(block, t.point, 0.0, t.force_y, t.force_z);
    kick(block);
    book_contact(points, tool);
    work += points.dt * tool.force * tool.speed;
    reached = strain;
    if (step % 20 == 0) note();
  }
  note();
  double sum = 0.0;
  int counted = 0;
  for (std::size_t k = 0; k < result.strain.size(); ++k)
    if (result.strain[k] > 0.05 && !turned) sum += std::pow(result.work[k] - result.work_exact[k], 2), ++counted;
  if (counted > 0) result.energy_rmse = std::sqrt(sum / counted) / result.work_exact.back();
  result.contact = tool.stored + tool.damped, result.radius = tool.radius_work;
  book_energy(block, result);
  result.residual = (work - result.contact - result.radius - result.internal - result.viscous - result.damping -
                     result.kinetic - result.hourglass) /
                    work;
}

}  // namespace apc::sph
