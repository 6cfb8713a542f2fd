#pragma once

#include <cstddef>
#include <vector>

#include "engine/view/geometry/curve.hpp"

namespace stepwire::geometry {

/// Share of the width of a picture that is less than a pixel.
constexpr double unseen = 2.5e-4;

/// Reduces a curve to about `limit` rows, in order. The minimum and maximum of every column in every range
/// are kept, so that no peak is lost.
Curve decimate(const Curve& curve, std::size_t limit);

/// Removes rows on the line between their neighbours, to within `tolerance` of the width of each column
/// (Ramer, Douglas, Peucker). With `colored`, the last column is a colour: it is no dimension, but changes by
/// at most forty tolerances between kept rows.
Curve simplify(const Curve& curve, const std::vector<double>& widths, double tolerance, bool colored);

/// Thins the curves of a group by their distance in the picture. Removed rows are within 6e-4 of its width of
/// the drawn lines, half a pixel of 800. If a curve over x still needs more than `budget` rows, its extremes
/// are kept instead. For any other curve that needs eight times as many, the distance is increased. Curves on
/// logarithmic axes are thinned regardless of their shape.
std::vector<Curve> thinned(const Curves& all, std::size_t group, std::size_t budget, bool colored = false);

/// Reduces all curves of a group to their share of the budget with their extremes, for points.
std::vector<Curve> cut(const Curves& all, std::size_t group, std::size_t budget);

}  // namespace stepwire::geometry
