#include "loadtables/fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "apc/base/require.h"
#include "loadtables/metamodel.h"

namespace apc::loadtables {
namespace {

constexpr double largest_ratio = 1.25;   // the spline reaches beyond the samples: tires do bottom, and that is no jump
constexpr double contact_ramp = 0.0625;  // loads start with C² over this share of P_max

const char* const names[responses] = {"drag", "vertical", "rut_depth", "spin_ratio"};

std::string place(const SampleSet& set) {
  return concat("samples of tire \"", set.tire, "\" in \"", set.material, "\": ");
}

void check(const SampleSet& set, const std::vector<Sample>& samples) {
  require(samples.size() >= 12, place(set), samples.size(),
          " usable samples (bed deeper than 2 cm, penetration above 0). At least 12 are needed");
  for (const auto& [contact, load] : samples) {
    require(std::isfinite(contact.speed) && std::isfinite(contact.bed_depth) && std::isfinite(contact.penetration) &&
                std::isfinite(load.drag) && std::isfinite(load.vertical),
            place(set), "a sample is not finite (speed ", contact.speed, ", depth ", contact.bed_depth,
            ", penetration ", contact.penetration, "). Leave it out");
    require(!set.has_rut || std::isfinite(load.rut_depth), place(set), "a rut depth is not finite. Leave it out");
    require(!set.has_spin || std::isfinite(load.spin_ratio), place(set), "a spin ratio is not finite. Leave it out");
  }
}

/// Responses the samples do not carry follow from the balance of tire and foam.
void complete(const SampleSet& set, const TableTire& tire, std::vector<Sample>& samples) {
  const MonotoneCurve curve(tire.curve_deflection, tire.curve_load);
  for (auto& [contact, load] : samples) {
    const double deflection = std::min(curve.inverse(std::max(load.vertical, 0.0)), contact.penetration);
    if (!set.has_rut) load.rut_depth = contact.penetration - deflection;
    if (!set.has_spin) load.spin_ratio = 0.5 * tire.diameter / (0.5 * tire.diameter - deflection / 3.0);
  }
}

/// Applies `matrix` (out × in) along the middle index of values[before][in][after].
std::vector<double> along(const Eigen::MatrixXd& matrix, const std::vector<double>& values, std::size_t before,
                          std::size_t after) {
  const auto in = static_cast<std::size_t>(matrix.cols()), out = static_cast<std::size_t>(matrix.rows());
  std::vector<double> result(before * out * after, 0.0);
  for (std::size_t b = 0; b < before; ++b)
    for (std::size_t o = 0; o < out; ++o)
      for (std::size_t i = 0; i < in; ++i) {
        const double factor = matrix(static_cast<Eigen::Index>(o), static_cast<Eigen::Index>(i));
        if (factor == 0.0) continue;
        for (std::size_t a = 0; a < after; ++a)
          result[(b * out + o) * after + a] += factor * values[(b * in + i) * after + a];
      }
  return result;
}

/// Nearest growing sequence in least squares (pool adjacent violators; Ayer et al. 1955, Ann. Math. Stat. 26, 641–647),
/// with at least `rise` between neighbours.
void make_growing(std::vector<double>& values, double rise) {
  struct Pool {
    double sum;
    std::size_t count;
    double mean() const { return sum / static_cast<double>(count); }
  };
  std::vector<Pool> pools;
  for (std::size_t i = 0; i < values.size(); ++i) {
    pools.push_back({values[i] - rise * static_cast<double>(i), 1});
    while (pools.size() > 1 && pools[pools.size() - 2].mean() > pools.back().mean()) {
      pools[pools.size() - 2].sum += pools.back().sum;
      pools[pools.size() - 2].count += pools.back().count;
      pools.pop_back();
    }
  }
  std::size_t i = 0;
  for (const auto& pool : pools)
    for (std::size_t k = 0; k < pool.count; ++k, ++i) values[i] = pool.mean() + rise * static_cast<double>(i);
}

/// A tire that sinks deeper is carried by more: where sparse samples leave ripples in the vertical load, they are
/// levelled along r. `line` starts at the first of `count` nodes of one speed and depth. Returns the largest relative
/// change.
double level_vertical(double* line, std::size_t count) {
  std::vector<double> values(count);
  for (std::size_t k = 0; k < count; ++k) values[k] = line[k * responses + vertical];
  const double largest = *std::max_element(values.begin(), values.end());
  if (!(largest > 0.0)) return 0.0;
  make_growing(values, 2e-4 * largest);
  double change = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    change = std::max(change, std::abs(values[k] - line[k * responses + vertical]) / largest);
    line[k * responses + vertical] = values[k];
  }
  return change;
}

/// Nodes along r, at one node of the depth axis, where the tire is in no deeper than its axle.
std::size_t carried_nodes(const LoadTable::Data& data, int depth_node) {
  const double largest = data.penetration.at(DepthScale::depth(data.depth.node(depth_node)));
  const double nodes = std::floor(0.5 * data.tire.diameter / largest / data.ratio.step) + 1.0;
  return static_cast<std::size_t>(std::min(nodes, static_cast<double>(data.ratio.nodes)));
}

void resample(const Metamodel& model, LoadTable::Data& data) {
  const auto speeds = static_cast<std::size_t>(data.speed.nodes), depths = static_cast<std::size_t>(data.depth.nodes),
             ratios = static_cast<std::size_t>(data.ratio.nodes);
  std::vector<double> values(speeds * depths * ratios * responses, 0.0);
  auto next = values.begin();
  for (int i = 0; i < data.speed.nodes; ++i)
    for (int j = 0; j < data.depth.nodes; ++j)
      for (int k = 0; k < data.ratio.nodes; ++k) {
        const double ratio = data.ratio.node(k);
        const double x = std::min(ratio / contact_ramp, 1.0), ramp = x * x * x * (10.0 + x * (6.0 * x - 15.0));
        if (ratio > 0.0)
          for (const double value : model(data.speed.node(i), DepthScale::depth(data.depth.node(j)), ratio))
            *next++ = ramp * value;
        else
          next += responses;
      }
  for (std::size_t line = 0; line < speeds * depths; ++line)
    data.growth_correction =
        std::max(data.growth_correction, level_vertical(values.data() + line * ratios * responses,
                                                        carried_nodes(data, static_cast<int>(line % depths))));
  values = along(interpolation(data.ratio, LowerEnd::rest), values, speeds * depths, responses);
  const auto ratio_count = static_cast<std::size_t>(data.ratio.coefficients());
  values = along(interpolation(data.depth, LowerEnd::linear), values, speeds, ratio_count * responses);
  const auto depth_count = static_cast<std::size_t>(data.depth.coefficients());
  values = along(interpolation(data.speed, LowerEnd::level), values, 1, depth_count * ratio_count * responses);
  // Single precision is a hundred times finer than the samples, and halves the files; the sum stays an exact spline.
  for (auto& value : values) value = static_cast<double>(static_cast<float>(value));
  data.coefficients = std::move(values);
}

double response(const TireLoad& load, std::size_t m) {
  return m == drag ? load.drag : m == vertical ? load.vertical : m == rut_depth ? load.rut_depth : load.spin_ratio;
}

std::vector<FitQuality> quality(const LoadTable& table, const SampleSet& set, const std::vector<Sample>& samples,
                                const std::array<double, responses>& leave_one_out,
                                const std::array<double, responses>& to_axle) {
  std::vector<FitQuality> list;
  for (std::size_t m = 0; m < responses; ++m) {
    if ((m == rut_depth && !set.has_rut) || (m == slip && !set.has_spin)) continue;
    const double count = static_cast<double>(samples.size());
    double mean = 0.0, mean_absolute = 0.0, residual = 0.0, spread = 0.0;
    for (const auto& sample : samples) {
      mean += response(sample.load, m) / count;
      mean_absolute += std::abs(response(sample.load, m)) / count;
    }
    for (const auto& sample : samples) {
      const double error = response(table.load(sample.contact), m) - response(sample.load, m);
      const double deviation = response(sample.load, m) - mean;
      residual += error * error, spread += deviation * deviation;
    }
    list.push_back({names[m], static_cast<int>(samples.size()), std::sqrt(residual / count) / mean_absolute,
                    leave_one_out[m], spread > 0.0 ? 1.0 - residual / spread : 1.0, to_axle[m]});
  }
  return list;
}

}  // namespace

LoadTable fit(const SampleSet& set, const TableTire& tire, const Provenance& provenance, const FitOptions& options) {
  auto samples = usable(set);
  check(set, samples);
  auto data = std::make_shared<LoadTable::Data>();
  data->penetration = penetration_scale(tire);
  complete(set, tire, samples);
  const auto model = learn(samples, tire, options.strength, options.rolling_resistance);
  data->tire = tire;
  data->provenance = provenance;
  data->samples = set;
  data->speeds = model.speeds;
  data->depths = {0.0, model.depths[1]};  // the pavement row is known exactly
  data->ratios = {model.ratios[0], std::max(model.ratios[1], 0.9)};
  data->speed = axis(0.0, std::max(model.speeds[1], 1.0), options.speed_nodes);
  data->depth = axis(DepthScale::at(0.0), DepthScale::at(model.depths[1]), options.depth_nodes);
  data->ratio = axis(0.0, largest_ratio, options.ratio_nodes);
  resample(model, *data);
  const LoadTable draft(data);
  data->quality =
      quality(draft, set, samples, leave_one_out_errors(model, samples, std::numeric_limits<double>::infinity()),
              leave_one_out_errors(model, samples, 0.5 * tire.diameter));
  return LoadTable(data);
}

}  // namespace apc::loadtables
