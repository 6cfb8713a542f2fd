#pragma once

#include "blocks/haptics/region/boundary_search.hpp"
#include "blocks/haptics/region/space_search.hpp"
#include "engine/model/block/block.hpp"
#include "engine/model/block/tree.hpp"

namespace stepwire {

/// Signed distance from the boundary of an authorized region in the plane or in space, and the nearest
/// boundary point.
struct Region {
  Tree shape;
  Input<> position{};
  Output<1> distance{};
  Output<> nearest{}, direction{};

  Numbers pieces{}, sleeves{};  ///< boundary in the plane, for BoundarySearch
  Numbers solids{};             ///< solids in space, for SpaceSearch
  double tolerance = 0.0;

  void outputs() {
    if (solids.empty()) {
      in_plane({position[0], position[1]});
    } else {
      in_space({position[0], position[1], position[2]});
    }
  }

  void configure(Configure& is);
  void outline(Outline& lines) const;

  static void declare(Declare<Region>& is);

 private:
  void in_plane(Vector2 from) {
    const BoundarySearch search{pieces.data(), pieces.size() / BoundarySearch::piece_size, sleeves.data(),
                                (sleeves.size() / BoundarySearch::sleeve_size + 1) / 2, tolerance};
    const BoundaryPoint found = search.nearest(from);
    const double side = found.facing > 0.0 ? 1.0 : -1.0;
    distance = side * found.distance;
    nearest[0] = found.at.x;
    nearest[1] = found.at.y;
    // On the boundary itself the direction to it is only rounding.
    const Vector2 way =
        found.distance > tolerance ? (side / found.distance) * (from - found.at) : found.normal;
    direction[0] = way.x;
    direction[1] = way.y;
  }

  void in_space(Vector3 from) {
    const SpaceSearch search{solids.data(), solids.size() / SpaceSearch::solid_size};
    const SpacePoint found = search.nearest(from);
    distance = found.distance;
    const Vector3 at = found.at, way = found.outward;
    nearest.each([&](Index i) { return i == 0 ? at.x : i == 1 ? at.y : at.z; });
    direction.each([&](Index i) { return i == 0 ? way.x : i == 1 ? way.y : way.z; });
  }
};

}  // namespace stepwire
