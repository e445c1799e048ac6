/// A made-up tire in a made-up bed for the tests: smooth, closed form, and not the reference physics of the fit.
#pragma once

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "loadtables/fit.h"
#include "loadtables/plan.h"

namespace apc::loadtables::synthetic {

inline TableTire tire() {
  TableTire tire;
  tire.name = "T40x14";
  tire.diameter = 1.0, tire.width = 0.36;
  tire.rated_load = 150e3, tire.rated_deflection = 0.08;
  tire.bottoming_load = 420e3, tire.bottoming_deflection = 0.19;
  tire.curve_deflection = {0.0, 0.08, 0.19};
  tire.curve_load = {0.0, 150e3, 420e3};
  return tire;
}

inline double rounded(double x, double width) { return 0.5 * (x + std::sqrt(x * x + width * width)); }

/// Foam carries until the rut reaches 0.83 h, then the tire's stiffness takes over; drag follows the rut.
inline TireLoad truth(const TireContact& contact) {
  const double p = contact.penetration, h = contact.bed_depth;
  const double compact = rounded(p - 0.83 * h - 0.03, 0.03) - rounded(-0.83 * h - 0.03, 0.03);
  const double rut = p - compact - 0.025 * (1.0 - std::exp(-p / 0.03));
  TireLoad load;
  load.vertical = 85e3 * (1.0 - std::exp(-p / 0.15)) + 2.2e6 * compact;
  load.drag = 1.9e5 * rut * (1.0 + 0.15 * std::pow(contact.speed / 36.0, 2)) + 0.014 * load.vertical;
  load.rut_depth = rut;
  load.spin_ratio = 1.0 - 0.3 * rut;
  return load;
}

inline SampleSet samples(int count = 70, unsigned seed = 1) {
  PlanOptions options;
  options.runs = count;
  options.seed = seed;
  SampleSet set;
  set.material = "made_up_foam", set.tire = tire().name, set.source = "closed form";
  set.has_rut = set.has_spin = true;
  for (const auto& run : make_plan(tire(), set.material, options).runs)
    set.samples.push_back({run.contact, truth(run.contact)});
  return set;
}

inline LoadTable table() {
  Provenance from;
  from.material = "made_up_foam", from.source = "closed form", from.command = "none", from.date = "2020-01-01";
  from.version = "1", from.friction = 0.3, from.spacing = 0.05, from.runs = 70, from.refused = 3;
  return fit(samples(), tire(), from);
}

/// A folder that lives as long as the test.
class Folder {
 public:
  explicit Folder(const std::string& name)
      : path_(std::filesystem::temp_directory_path() / ("apc_" + name + "_" + std::to_string(getpid()))) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace apc::loadtables::synthetic
