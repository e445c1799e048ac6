/// Points on the earth: the direct and the inverse problem on the WGS 84 ellipsoid (Vincenty, Survey Review 23, 1975,
/// 88–93), good to a fraction of a millimetre over the lengths of runways.
#pragma once

namespace apc::site {

/// Geographic coordinates, rad; north and east positive.
struct Place {
  double latitude = 0.0, longitude = 0.0;
};

/// The place `distance` m away from `from` along the azimuth `heading` (rad, clockwise from true north).
Place away(const Place& from, double heading, double distance);

/// The shortest way from one place to another: its length, m, and its azimuth at the start, rad in [0, 2π). Places must
/// not be nearly opposite on the earth (the iteration does not settle there).
struct Way {
  double length = 0.0, heading = 0.0;
};
Way way(const Place& from, const Place& to);

}  // namespace apc::site
