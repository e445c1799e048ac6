#include "sph_backend/published_study.h"

#include <map>
#include <tuple>

#include "apc/base/units.h"

namespace apc::sph {

Published published(Study study, Method method, const std::string& quantity) {
  using units::in;
  using units::lbf;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const double line = lbf / in;
  static const std::map<std::tuple<Study, Method, std::string>, Published> table{
      {{Study::platen_1d, Method::fem, "energy_rmse"}, {0.0073, 4.165, none, 0.999, none}},
      {{Study::platen_1d, Method::sph, "energy_rmse"}, {0.0378, 3.293, none, 1.000, none}},
      {{Study::roller_2d, Method::fem, "vertical"}, {875 * line, 1.04, 0.098, none, 0.085}},
      {{Study::roller_2d, Method::fem, "drag"}, {1091 * line, 1.42, 0.038, none, 0.031}},
      {{Study::roller_2d, Method::fem, "hourglass_share"}, {0.170, none, none, none, none}},
      {{Study::roller_2d, Method::sph, "vertical"}, {845 * line, 1.01, 0.050, none, 0.042}},
      {{Study::roller_2d, Method::sph, "drag"}, {1117 * line, 1.02, 0.055, none, 0.046}},
      {{Study::tire_3d, Method::fem, "vertical"}, {10730 * lbf, 1.472, none, 0.999, 0.153}},
      {{Study::tire_3d, Method::fem, "drag"}, {8144 * lbf, 1.162, none, 0.999, 0.234}},
      {{Study::tire_3d, Method::fem, "internal_energy_rate"}, {7591 * lbf, 1.000, none, 0.995, 0.094}},
      {{Study::tire_3d, Method::fem, "hourglass_share"}, {0.194, none, none, none, none}},
      {{Study::tire_3d, Method::sph, "vertical"}, {10400 * lbf, 3.331, none, 0.993, 0.003}},
      {{Study::tire_3d, Method::sph, "drag"}, {10030 * lbf, 6.902, none, 0.786, 0.012}},
      {{Study::tire_3d, Method::sph, "internal_energy_rate"}, {7996 * lbf, 2.263, none, 0.998, 0.015}},
  };
  const auto found = table.find({study, method, quantity});
  return found == table.end() ? Published{} : found->second;
}

}  // namespace apc::sph
