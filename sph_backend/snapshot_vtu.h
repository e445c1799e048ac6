/// Snapshots for a scientific viewer: particles and tire surface as VTU (binary), a PVD file as their time axis.
#pragma once

#include <filesystem>
#include <vector>

#include "sph_backend/rolling_run.h"

namespace apc::sph {

class SnapshotSeries {
 public:
  explicit SnapshotSeries(std::filesystem::path folder) : folder_(std::move(folder)) {}
  /// Goes on with a series that an interrupted run left: keeps what it had until `time`. Returns the time of the last
  /// snapshot kept, negative if there is none.
  double resume(double time);
  /// Writes particles_NNNN.vtu and tire_NNNN.vtu and renews run.pvd.
  void write(const RollingRun&);

 private:
  std::filesystem::path folder_;
  std::vector<double> times_;
};

}  // namespace apc::sph
