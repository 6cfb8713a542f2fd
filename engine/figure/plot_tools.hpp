#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

#include "engine/figure/curve.hpp"
#include "engine/figure/plot_kind.hpp"
#include "engine/figure/script.hpp"
#include "engine/figure/thinning.hpp"

namespace stepwire {

/// All rows of all curves as one.
Curve joined(const Curves& all);

/// Smallest and largest value of a column.
Extent extent_of(const std::vector<double>& values);

/// Draws y over x as coloured curves, one colour for each y and each value of `by`; the legend tells them
/// apart. Many values of `by` are told apart by a colour bar instead.
void draw_curves(const Panel& panel, std::span<const Recording> recordings, Script& script);

/// Recording of the i-th y, or of the panel.
const Recording& recording_of(const Panel& panel, std::span<const Recording> recordings,
                              std::size_t index = 0);

/// A numeric option, or what holds without it.
double number_or(const Panel& panel, const std::string& key, double otherwise);

}  // namespace stepwire
