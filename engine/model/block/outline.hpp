#pragma once

#include <array>
#include <vector>

namespace stepwire {

/// Lines that a block offers to figures, such as the boundary of a region; its `void outline(Outline& lines)
/// const` adds them. Coordinates are in SI. Plane lines are closed and counter-clockwise, with the inside to
/// the left.
struct Outline {
  using Point = std::array<double, 3>;  ///< z is 0 in the plane

  struct Line {
    std::vector<Point> points;
    bool endless = false;  ///< periodic or infinite: only its first part is given
  };

  bool space = false;  ///< its points have three coordinates
  std::vector<Line> lines;
};

}  // namespace stepwire
