#pragma once

#include <vector>

#include "blocks/haptics/region/boundary_search.hpp"
#include "blocks/haptics/region/plane_chain.hpp"

namespace stepwire {

/// Region of the plane, represented by its boundary; each piece has the side of the region.
using PlaneShape = std::vector<PlanePiece>;

/// Numbers of a boundary for BoundarySearch.
struct BoundaryTable {
  explicit BoundaryTable(const PlaneShape& shape);

  std::vector<double> pieces, sleeves;
  Index leaves = 1;
  double tolerance = 0.0;

  BoundarySearch search() const {
    return {pieces.data(), static_cast<Index>(pieces.size()) / BoundarySearch::piece_size, sleeves.data(),
            leaves, tolerance};
  }
};

/// Returns the pieces in order along the boundary, each after its predecessor, as loops; an open one begins
/// at its end.
std::vector<PlaneShape> loops_of(const PlaneShape& shape);

/// Returns the size below which details of a shape are treated as one point.
double fineness_of(const PlaneShape& shape);

/// Returns a disk, or with an inner radius above 0 an annulus.
PlaneShape disk(Vector2 centre, double radius, double inner_radius);
/// Returns a polygon. Throws ShapeError if it crosses itself.
PlaneShape polygon(std::vector<Vector2> corners);

/// Returns all points within half_width of a chain. Throws ShapeError if it touches itself.
PlaneShape corridor(const PlaneChain& chain, double half_width);

/// Side of a band: x as a function of y; the chain leads upward.
struct BandSide {
  PlaneChain chain;
  std::function<double(double y)> x;
};
/// Returns all points with low <= y <= high and left(y) <= x <= right(y); nullptr omits a side. Throws
/// ShapeError if the sides cross or leave no points.
PlaneShape band(const BandSide* left, const BandSide* right, double low, double high);

/// Returns the union of the shapes.
PlaneShape united(const std::vector<PlaneShape>& shapes);

/// Predicate of the parts of a cut piece. kept_parts() cuts pieces at their intersections with `others` and
/// keeps the parts for which it is true.
using IsKept = std::function<bool(const PlanePiece& part)>;
PlaneShape kept_parts(const PlaneShape& pieces, const PlaneShape& others, double tolerance,
                      const IsKept& is_kept);

/// Returns a point of a piece that is not one of its ends.
Vector2 inner_point(const PlanePiece& piece, double reach);

}  // namespace stepwire
