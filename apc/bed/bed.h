/// An arrestor bed: where it starts, how deep the crushable material is along the runway, and what it is made of.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace apc {
class Json;
}

namespace apc::bed {

/// Where the flat side of the bed lies.
enum class Flush {
  top,   ///< the top surface is level with the pavement, the base falls away below it
  base,  ///< the base is level with the pavement, the top surface rises (a raised bed with a ramp)
};

/// Data-sheet values of the material the load tables were made with.
struct NominalMaterial {
  double strength = 0.0;          ///< crushing strength, Pa
  double density = 0.0;           ///< kg/m³
  double bottoming_strain = 0.0;  ///< volumetric strain at which the material is fully compacted
};

/// Lengths in m. `distance` starts at 0 (the leading edge) and increases strictly; `depth` is ≥ 0, linear in between.
struct Bed {
  std::string name, source, material;
  double setback = 0.0;  ///< from the pavement end (x = 0) to the leading edge
  double width = 0.0;
  Flush flush = Flush::top;
  std::vector<double> distance, depth;
  double block_length = 0.0, block_width = 0.0;  ///< 0 when the file gives none
  double grade = 0.0;                            ///< rise over run of the whole site
  std::optional<NominalMaterial> nominal;
  std::string built;  ///< date of installation, "2019-03-01"; empty when unknown

  double length() const { return distance.back(); }
  double maximum_depth() const;
  double volume() const;  ///< m³
  /// Depth of material at a distance from the leading edge; 0 before the bed and behind it.
  double depth_at(double bed_distance) const;
  double depth_slope_at(double bed_distance) const;
  /// Height of the top surface above the pavement plane: 0 for Flush::top, the depth for Flush::base.
  double top_at(double bed_distance) const { return flush == Flush::base ? depth_at(bed_distance) : 0.0; }
};

/// Reads schema "apc-bed/1". Throws InputError: file, path, value, remedy.
Bed load_bed(const std::filesystem::path&);
/// The same from an object of another file.
Bed read_bed(const Json&);

}  // namespace apc::bed
