#pragma once

#include <algorithm>
#include <limits>

#include "blocks/haptics/region/plane.hpp"
#include "engine/model/signal/index.hpp"

namespace stepwire {

/// Point of a boundary that is nearest to a position.
struct BoundaryPoint {
  Vector2 at, normal;  ///< the normal points out of the region
  double distance = std::numeric_limits<double>::infinity();
  double facing = 0.0;  ///< cosine between the normal and the vector to the position: above 0 outside
  Index piece = -1;
};

/// Finds the nearest point of a boundary in the plane.
///
/// The boundary consists of straight lines and circular arcs. Each of them is `piece_size` numbers in memory.
/// Line: 0, start x y, direction x y, length, side;
/// Arc: radius * side, centre x y, direction x y from the centre to its middle, cosine and sine of half its
/// angle. Side is 1 if the region is to the left of the line or inside of the circle, else -1.
///
/// The search is a branch and bound on a tree of sleeves. A sleeve is the set of points within a radius of a
/// line segment. Around pieces of a curve it is much tighter than a box, so fewer pieces are visited. Each
/// leaf covers `leaf_size` successive pieces. The tree is complete and binary with `leaves` leaves (a power
/// of 2). Each node, beginning with the root, has start x y, direction x y and length of its segment, and its
/// radius.
struct BoundarySearch {
  static constexpr Index piece_size = 7, leaf_size = 4, sleeve_size = 6;

  const double* pieces = nullptr;
  Index count = 0;
  const double* sleeves = nullptr;
  Index leaves = 0;
  double tolerance = 0.0;  ///< distances that differ by less are equal

  BoundaryPoint nearest(Vector2 from) const {
    BoundaryPoint best;
    Open open[64];  // more than the depth of any tree whose leaves fit into an index
    Index waiting = 0;
    open[waiting++] = {0, 0.0};
    while (waiting > 0) {
      const Open next = open[--waiting];
      if (!(next.least <= best.distance + tolerance)) continue;
      if (next.node >= leaves - 1) {
        look_at_leaf(next.node - (leaves - 1), from, best);
        continue;
      }
      const Open left{2 * next.node + 1, distance_to_sleeve(2 * next.node + 1, from)};
      const Open right{2 * next.node + 2, distance_to_sleeve(2 * next.node + 2, from)};
      const bool left_is_nearer = left.least <= right.least;
      open[waiting++] = left_is_nearer ? right : left;
      open[waiting++] = left_is_nearer ? left : right;
    }
    return best;
  }

 private:
  /// Node to be visited, and a lower bound of the distance of its pieces.
  struct Open {
    Index node;
    double least;
  };

  double distance_to_sleeve(Index node, Vector2 from) const {
    const double* sleeve = sleeves + sleeve_size * node;
    const Vector2 start{sleeve[0], sleeve[1]}, along{sleeve[2], sleeve[3]};
    const double s = std::min(std::max(dot(from - start, along), 0.0), sleeve[4]);
    return length(from - (start + s * along)) - sleeve[5];
  }

  void look_at_leaf(Index leaf, Vector2 from, BoundaryPoint& best) const {
    const Index end = std::min(count, (leaf + 1) * leaf_size);
    for (Index i = leaf * leaf_size; i < end; ++i) {
      const double* piece = pieces + piece_size * i;
      const Touch touch = piece[0] == 0.0 ? touch_of_line(piece, from) : touch_of_arc(piece, from);
      const Vector2 way = from - touch.at;
      const double square = dot(way, way), reach = best.distance + tolerance;
      if (!(square <= reach * reach)) continue;
      const double distance = length(way);
      const double facing = distance > 0.0 ? dot(touch.normal, way) / distance : 0.0;
      const BoundaryPoint found{touch.at, touch.normal, distance, facing, i};
      if (is_better(found, best)) best = found;
    }
  }

  /// True if a point replaces the best one. At a corner both pieces are equally near; the one with the larger
  /// |facing| determines the side of the position. If that is equal too, the first piece of the boundary is
  /// used.
  bool is_better(const BoundaryPoint& found, const BoundaryPoint& best) const {
    if (found.distance < best.distance - tolerance) return true;
    const double advantage = std::abs(found.facing) - std::abs(best.facing);
    return advantage > 1e-9 || (advantage > -1e-9 && found.piece < best.piece);
  }

  /// Nearest point of one piece.
  struct Touch {
    Vector2 at, normal;
  };

  static Touch touch_of_line(const double* piece, Vector2 from) {
    const Vector2 start{piece[1], piece[2]}, along{piece[3], piece[4]};
    const double s = std::min(std::max(dot(from - start, along), 0.0), piece[5]);
    return {start + s * along, -piece[6] * turned_left(along)};
  }

  static Touch touch_of_arc(const double* piece, Vector2 from) {
    const double radius = std::abs(piece[0]), side = piece[0] > 0.0 ? 1.0 : -1.0;
    const Vector2 centre{piece[1], piece[2]}, middle{piece[3], piece[4]};
    const Vector2 arm = from - centre;
    const double away = length(arm);
    Vector2 ray = (1.0 / away) * arm;
    if (!(away > 0.0 && dot(ray, middle) >= piece[5])) {  // the end on the side of the position
      const double turn = cross(middle, arm) > 0.0 ? piece[6] : -piece[6];
      ray = piece[5] * middle + turn * turned_left(middle);
    }
    return {centre + radius * ray, side * ray};
  }
};

}  // namespace stepwire
