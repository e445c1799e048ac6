/// A tire as its catalogue gives it: outer shape, pressure, and two points of its load–deflection curve.
///
/// Cross-section: ellipse with semi-axes width/2 (lateral) and section height/2 (radial), section height
/// (diameter − rim)/2, for the tread half; below the widest point the side narrows to 0.8 of the half-width at the rim
/// (the rim's flange) and stays there. The shoulder is that of the ellipse: declared, not measured.
#pragma once

#include <string>

namespace apc::sph {

struct TireShape {
  std::string name;
  double diameter = 0.0, width = 0.0, rim_diameter = 0.0;   ///< m
  double inflation = 0.0;                                   ///< gauge, Pa
  double rated_load = 0.0, rated_deflection = 0.0;          ///< N, m; whole tire on a flat rigid plane
  double bottoming_load = 0.0, bottoming_deflection = 0.0;  ///< N, m
};

/// Load on a rigid plane at a deflection: monotone cubic through (0, 0), the rated and the bottoming point.
double catalogue_load(const TireShape&, double deflection);
/// Deflection at `load` on the same curve.
double catalogue_deflection(const TireShape&, double load);

/// 0.85 of the bed depth plus the tire's deflection at 80 % of its bottoming load, at most the diameter (ACRP
/// 29, 9.4.4).
double maximum_penetration(const TireShape&, double bed_depth);

/// Distance to the section's outline in the meridional plane and its outward normal there. `radial` is measured from
/// the circle of the widest points, `lateral` ≥ 0 from the wheel plane; distance > 0 outside, first order in the
/// distance.
struct SectionPoint {
  double distance, normal_radial, normal_lateral;
};
struct Section {
  double lateral;  ///< semi-axis a
  double radial;   ///< semi-axis b of the tread half
  double centre;   ///< radius of the widest points
  SectionPoint at(double radial_offset, double lateral_offset) const;
};
Section section(const TireShape&);

}  // namespace apc::sph
