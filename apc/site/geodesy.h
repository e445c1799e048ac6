/// Points on the earth: the direct problem on the WGS 84 ellipsoid (Vincenty, Survey Review 23, 1975, 88–93), good to
/// a fraction of a millimetre over the lengths of runways.
#pragma once

namespace apc::site {

/// Geographic coordinates, rad; north and east positive.
struct Place {
  double latitude = 0.0, longitude = 0.0;
};

/// The place `distance` m away from `from` along the azimuth `heading` (rad, clockwise from true north).
Place away(const Place& from, double heading, double distance);

}  // namespace apc::site
