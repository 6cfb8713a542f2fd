#pragma once

#include <vector>

#include "blocks/haptics/region/space.hpp"

namespace stepwire {

/// All points within a radius of a line segment, without those within an inner radius.
struct Solid {
  Vector3 start, along{0.0, 0.0, 1.0};
  double length = 0.0, radius = 0.0, inner_radius = 0.0;
};

using SpaceShape = std::vector<Solid>;

Solid ball(Vector3 centre, double radius, double inner_radius);
/// Returns a straight corridor. Throws ShapeError if both ends are equal.
Solid corridor(Vector3 start, Vector3 end, double half_width);

/// Throws ShapeError if two solids touch.
void refuse_contact(const SpaceShape& solids);

/// Returns the numbers for SpaceSearch.
std::vector<double> numbers_of(const SpaceShape& solids);

}  // namespace stepwire
