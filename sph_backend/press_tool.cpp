#include "sph_backend/press_tool.h"

#include <algorithm>
#include <cmath>

namespace apc::sph {
namespace {

struct Gap {
  double distance, gradient_y, gradient_z;  ///< to the tool, positive outside; ∂distance/∂(y, z)
};

Gap gap_to(const PressTool& tool, double y, double z) {
  const double below = tool.height - z, beside = y - tool.half_width;  // positive outside
  if (beside <= 0.0 && (below >= beside || below > 0.0)) return {below, 0.0, -1.0};
  if (below <= 0.0) return {beside, 1.0, 0.0};
  const double distance = std::max(std::hypot(below, beside), 1e-12);
  return {distance, beside / distance, -below / distance};
}

}  // namespace

void find_contact(const ContactPoints& p, PressTool& tool, const float* stretch_before) {
  tool.force = tool.stored = 0.0;
  tool.touches.clear();
  const double k = p.stiffness, c = 2.0 * tool.damping_ratio * std::sqrt(k * p.mass);
  for (std::size_t n = 0; n < p.count; ++n) {
    const std::size_t i = p.which != nullptr ? p.which[n] : n;
    if (p.id != nullptr && p.id[i] < 0) continue;
    const double radius = p.radius(p.stretch, i);
    const Gap gap = gap_to(tool, p.y[i], p.z[i]);
    const double overlap = radius - gap.distance;
    if (overlap <= 0.0) continue;
    const double rate = gap.gradient_y * p.vy[i] + gap.gradient_z * (p.vz[i] + tool.speed);
    const double elastic = k * overlap, damping = std::max(-c * rate, -elastic), size = elastic + damping;
    tool.touches.push_back({static_cast<std::uint32_t>(i), size * gap.gradient_y, size * gap.gradient_z, elastic,
                            damping, gap.gradient_y, gap.gradient_z, p.vy[i], p.vz[i]});
    tool.force -= size * gap.gradient_z;
    tool.stored += 0.5 * k * overlap * overlap;
    tool.radius_work -= elastic * (radius - p.radius(stretch_before, i));
  }
}

void book_contact(const ContactPoints& p, PressTool& tool) {
  for (const auto& t : tool.touches) {
    const double y = 0.5 * (t.before_y + p.vy[t.point]), z = 0.5 * (t.before_z + p.vz[t.point]) + tool.speed;
    tool.damped -= p.dt * t.damping * (t.gradient_y * y + t.gradient_z * z);
  }
}

}  // namespace apc::sph
