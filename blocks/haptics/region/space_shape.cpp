#include "blocks/haptics/region/space_shape.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "blocks/haptics/region/plane_chain.hpp"

namespace stepwire {

Solid ball(Vector3 centre, double radius, double inner_radius) {
  return {centre, {0.0, 0.0, 1.0}, 0.0, radius, inner_radius};
}

Solid corridor(Vector3 start, Vector3 end, double half_width) {
  const double whole = length(end - start);
  if (!(whole > 0.0)) throw ShapeError("both ends of it are the same point");
  return {start, (1.0 / whole) * (end - start), whole, half_width, 0.0};
}

namespace {

double distance_to(const Solid& line, Vector3 point) {
  const double s = std::clamp(dot(point - line.start, line.along), 0.0, line.length);
  return length(point - (line.start + s * line.along));
}

/// Returns the distance between the axes. The distance of a point of one to the other is a convex function,
/// so ternary search finds the minimum.
double distance_between(const Solid& a, const Solid& b) {
  double low = 0.0, high = a.length;
  const auto at = [&](double s) { return distance_to(b, a.start + s * a.along); };
  for (int i = 0; i < 120; ++i) {
    const double third = (high - low) / 3.0;
    const bool first_is_nearer = at(low + third) <= at(high - third);
    if (first_is_nearer) high -= third;
    if (!first_is_nearer) low += third;
  }
  return at(0.5 * (low + high));
}

}  // namespace

void refuse_contact(const SpaceShape& solids) {
  for (std::size_t i = 0; i < solids.size(); ++i)
    for (std::size_t k = i + 1; k < solids.size(); ++k) {
      const double gap = distance_between(solids[i], solids[k]) - solids[i].radius - solids[k].radius;
      if (gap <= 0.0)
        throw ShapeError(fmt::format("shapes {} and {} of it overlap by {}; in space they must be apart",
                                     i + 1, k + 1, shown(-gap)));
    }
}

std::vector<double> numbers_of(const SpaceShape& solids) {
  std::vector<double> numbers;
  for (const Solid& solid : solids)
    numbers.insert(numbers.end(), {solid.start.x, solid.start.y, solid.start.z, solid.along.x, solid.along.y,
                                   solid.along.z, solid.length, solid.radius, solid.inner_radius});
  return numbers;
}

}  // namespace stepwire
