#pragma once

#include <vector>

#include "blocks/haptics/region/boundary_search.hpp"
#include "blocks/haptics/region/plane_chain.hpp"

namespace stepwire {

/// A region of the plane, known by its boundary; each piece knows on which side the region lies.
using PlaneShape = std::vector<PlanePiece>;

/// The numbers of a boundary as BoundarySearch reads them.
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

/// The pieces in their order along the boundary, each behind the one where it begins: loops, of which an open
/// one begins at its end.
std::vector<PlaneShape> loops_of(const PlaneShape& shape);

/// Size below which details of a shape are taken for one point.
double fineness_of(const PlaneShape& shape);

/// A disk, or with an inner radius above 0 an annulus.
PlaneShape disk(Vector2 centre, double radius, double inner_radius);
/// Throws ShapeError where the polygon crosses itself.
PlaneShape polygon(std::vector<Vector2> corners);

/// All points within half_width of a chain. Throws ShapeError where it touches itself.
PlaneShape corridor(const PlaneChain& chain, double half_width);

/// One side of a band: x as a function of y; the chain goes upward.
struct BandSide {
  PlaneChain chain;
  std::function<double(double y)> x;
};
/// All points with low <= y <= high and left(y) <= x <= right(y); a side that is null is not there. Throws
/// ShapeError where the sides cross or leave nothing.
PlaneShape band(const BandSide* left, const BandSide* right, double low, double high);

/// What lies in at least one of the shapes.
PlaneShape united(const std::vector<PlaneShape>& shapes);

/// What is left of pieces that are cut wherever they meet one of `others`, when only those parts are kept for
/// which this is so.
using IsKept = std::function<bool(const PlanePiece& part)>;
PlaneShape kept_parts(const PlaneShape& pieces, const PlaneShape& others, double tolerance,
                      const IsKept& is_kept);

/// A point of a piece that is not one of its ends.
Vector2 inner_point(const PlanePiece& piece, double reach);

}  // namespace stepwire
