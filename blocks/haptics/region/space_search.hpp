#pragma once

#include <algorithm>
#include <limits>

#include "blocks/haptics/region/space.hpp"
#include "engine/model/signal/index.hpp"

namespace stepwire {

/// Point of a boundary in space that is nearest to a position.
struct SpacePoint {
  Vector3 at, outward;
  double distance = std::numeric_limits<double>::infinity();  ///< negative inside
};

/// Finds the nearest point of disjoint solids. A solid is the set of points within a radius of a straight
/// axis, of length 0 for a sphere; a shell excludes an inner radius. Each has `solid_size` numbers in memory:
/// start of the axis x y z, its direction x y z, its length, radius, inner radius.
struct SpaceSearch {
  static constexpr Index solid_size = 9;

  const double* solids = nullptr;
  Index count = 0;

  SpacePoint nearest(Vector3 from) const {
    SpacePoint best;
    for (Index i = 0; i < count; ++i) {
      const SpacePoint found = nearest_on(solids + solid_size * i, from);
      if (found.distance < best.distance) best = found;
    }
    return best;
  }

 private:
  static SpacePoint nearest_on(const double* solid, Vector3 from) {
    const Vector3 start{solid[0], solid[1], solid[2]}, along{solid[3], solid[4], solid[5]};
    const double s = std::min(std::max(dot(from - start, along), 0.0), solid[6]);
    const Vector3 middle = start + s * along, arm = from - middle;
    const double away = length(arm), radius = solid[7], inner = solid[8];
    const Vector3 ray = away > 0.0 ? (1.0 / away) * arm : beside(along);
    if (inner > 0.0 && inner - away > away - radius) return {middle + inner * ray, -1.0 * ray, inner - away};
    return {middle + radius * ray, ray, away - radius};
  }
};

}  // namespace stepwire
