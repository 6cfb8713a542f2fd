#pragma once

#include <array>
#include <vector>

namespace stepwire {

/// Lines that a block offers to figures, such as the boundary of a region: `void outline(Outline& lines)
/// const` of the block adds them. Coordinates are in SI. Lines in the plane are closed, and run through with
/// the inside to the left.
struct Outline {
  using Point = std::array<double, 3>;  ///< z is 0 in the plane

  struct Line {
    std::vector<Point> points;
    bool endless = false;  ///< goes on without end: only its first stretch is here
  };

  bool space = false;  ///< it has three coordinates
  std::vector<Line> lines;
};

}  // namespace stepwire
