#pragma once

#include <cstddef>
#include <vector>

#include "engine/view/geometry/curve.hpp"

namespace stepwire::geometry {

/// Share of the width of a picture that is a fraction of a pixel.
constexpr double unseen = 2.5e-4;

/// At most about `limit` rows of a curve, in their order, among them the smallest and largest of every column
/// in every stretch, so that no peak is lost.
Curve decimate(const Curve& curve, std::size_t limit);

/// Leaves out rows that lie on the line between their neighbours, to within `tolerance` of the width of each
/// column (Ramer, Douglas, Peucker). If `colored`, the last column is a colour: it is no direction, but it
/// changes by no more than forty tolerances from one row to the next that is kept.
Curve simplify(const Curve& curve, const std::vector<double>& widths, double tolerance, bool colored);

/// Thins the curves of a group by their distance on the picture: removed rows are within 6e-4 of its width of
/// the drawn lines, half a pixel of 800. A curve over x that needs more than `budget` rows for that keeps its
/// extremes instead; the distance grows for another one that needs eight times as many. Logarithmic axes are
/// thinned without regard to shape.
std::vector<Curve> thinned(const Curves& all, std::size_t group, std::size_t budget, bool colored = false);

/// All curves of a group, each cut to its share of the budget with its extremes kept; for points.
std::vector<Curve> cut(const Curves& all, std::size_t group, std::size_t budget);

}  // namespace stepwire::geometry
