#pragma once

#include <vector>

#include "blocks/haptics/region/space.hpp"

namespace stepwire {

/// All points within a radius of a straight line, without those within an inner radius of it.
struct Solid {
  Vector3 start, along{0.0, 0.0, 1.0};
  double length = 0.0, radius = 0.0, inner_radius = 0.0;
};

using SpaceShape = std::vector<Solid>;

Solid ball(Vector3 centre, double radius, double inner_radius);
/// A straight corridor. Throws ShapeError where both ends are the same point.
Solid corridor(Vector3 start, Vector3 end, double half_width);

/// Throws ShapeError where two solids are not apart from each other.
void refuse_contact(const SpaceShape& solids);

/// The numbers that SpaceSearch reads.
std::vector<double> numbers_of(const SpaceShape& solids);

}  // namespace stepwire
