#include "engine/view/geometry/thinning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stepwire::geometry {
namespace {

/// Adds the rows of a range that must be kept: its first one, and the extremes of each column.
void keep_extremes(const Curve& curve, std::size_t begin, std::size_t end, std::vector<std::size_t>& rows) {
  std::vector<std::size_t> kept{begin};
  for (const auto& column : curve.columns) {
    const auto from = column.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto to = column.begin() + static_cast<std::ptrdiff_t>(end);
    const auto [low, high] = std::minmax_element(from, to);
    kept.push_back(static_cast<std::size_t>(low - column.begin()));
    kept.push_back(static_cast<std::size_t>(high - column.begin()));
  }
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  rows.insert(rows.end(), kept.begin(), kept.end());
}

Curve chosen_rows(const Curve& curve, const std::vector<std::size_t>& rows) {
  Curve result{std::vector<std::vector<double>>(curve.columns.size()), curve.group};
  for (std::size_t i = 0; i < curve.columns.size(); ++i)
    for (const std::size_t row : rows) result.columns[i].push_back(curve.columns[i][row]);
  return result;
}

/// Distance of rows from the chord between two of them, in widths of the columns.
class Chord {
 public:
  Chord(const Curve& curve, const std::vector<double>& widths, std::size_t axes, std::size_t a, std::size_t b)
      : curve_(curve), widths_(widths), axes_(axes), a_(a), b_(b) {
    for (std::size_t i = 0; i < axes_; ++i) length2_ += offset(i, b_) * offset(i, b_);
  }

  double distance(std::size_t row) const {
    double along = 0.0, square = 0.0;
    for (std::size_t i = 0; i < axes_; ++i) along += offset(i, row) * offset(i, b_);
    const double part = length2_ > 0.0 ? std::clamp(along / length2_, 0.0, 1.0) : 0.0;
    for (std::size_t i = 0; i < axes_; ++i) {
      const double away = offset(i, row) - part * offset(i, b_);
      square += away * away;
    }
    return std::sqrt(square);
  }

 private:
  double offset(std::size_t column, std::size_t row) const {
    return (curve_.columns[column][row] - curve_.columns[column][a_]) / widths_[column];
  }

  const Curve& curve_;
  const std::vector<double>& widths_;
  std::size_t axes_, a_, b_;
  double length2_ = 0.0;
};

void keep_shape(const Curve& curve, const std::vector<double>& widths, std::size_t axes, double tolerance,
                std::vector<bool>& kept) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, curve.size() - 1}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    const Chord chord(curve, widths, axes, a, b);
    std::size_t farthest = a;
    double most = tolerance;
    for (std::size_t row = a + 1; row < b; ++row) {
      const double distance = chord.distance(row);
      if (distance > most) {
        most = distance;
        farthest = row;
      }
    }
    if (farthest == a) continue;
    kept[farthest] = true;
    open.push_back({a, farthest});
    open.push_back({farthest, b});
  }
}

/// Keeps rows at changes of colour. A segment has one colour, so it ends where the colour changes, and a jump
/// is a short segment of its own.
void keep_colors(const std::vector<double>& color, double step, std::vector<bool>& kept) {
  double last = color.front();
  const auto changes = [&](std::size_t row) { return std::abs(color[row] - last) > step; };
  for (std::size_t row = 1; row < color.size(); ++row) {
    if (changes(row)) {
      kept[row - 1] = true;
      last = color[row - 1];
    }
    if (changes(row)) kept[row] = true;
    if (kept[row]) last = color[row];
  }
}

/// Returns the displayed width of each column: of its values, or of its given range.
std::vector<double> widths_of(const Curves& all) {
  std::vector<double> low, high;
  for (const Curve& curve : all.curves) {
    low.resize(curve.columns.size(), std::numeric_limits<double>::infinity());
    high.resize(curve.columns.size(), -std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < curve.columns.size(); ++i)
      for (const double value : curve.columns[i]) {
        low[i] = std::min(low[i], value);
        high[i] = std::max(high[i], value);
      }
  }
  for (std::size_t i = 0; i < low.size(); ++i) {
    high[i] = high[i] > low[i] ? high[i] - low[i] : 1.0;
    if (i < all.shown.size()) high[i] = std::min(high[i], all.shown[i]);
  }
  return high;
}

/// Smallest visible distance between successive rows, in widths of the columns.
constexpr double near = 1e-4;
/// Factor of the budget up to which curves keep their shape.
constexpr std::size_t shape_excess = 8;

/// Removes rows that are nearer than `distance` to the last kept one and have its colour.
Curve sparser(const Curve& curve, const std::vector<double>& widths, double distance, bool colored) {
  if (curve.size() < 3) return curve;
  const std::size_t axes = curve.columns.size() - (colored ? 1 : 0);
  std::vector<std::size_t> kept{0};
  const auto is_far = [&](std::size_t row) {
    double square = 0.0;
    for (std::size_t i = 0; i < axes; ++i) {
      const double away = (curve.columns[i][row] - curve.columns[i][kept.back()]) / widths[i];
      square += away * away;
    }
    const bool changes = colored && std::abs(curve.columns.back()[row] - curve.columns.back()[kept.back()]) >
                                        unseen * widths.back();
    return changes || square > distance * distance;
  };
  for (std::size_t row = 1; row + 1 < curve.size(); ++row)
    if (is_far(row)) kept.push_back(row);
  kept.push_back(curve.size() - 1);
  return chosen_rows(curve, kept);
}

/// True for a curve over an increasing column, such as time.
bool ascends(const Curve& curve) {
  return std::ranges::is_sorted(curve.columns.front());
}

std::vector<Curve> of_group(const Curves& all, std::size_t group) {
  std::vector<Curve> curves;
  for (const Curve& curve : all.curves)
    if (curve.group == group) curves.push_back(curve);
  return curves;
}

std::size_t rows_of(const std::vector<Curve>& curves) {
  std::size_t rows = 0;
  for (const Curve& curve : curves) rows += curve.size();
  return rows;
}

}  // namespace

Curve decimate(const Curve& curve, std::size_t limit) {
  const std::size_t rows = curve.size();
  if (rows <= limit) return curve;
  const std::size_t stretches = std::max<std::size_t>(1, limit / (2 * curve.columns.size() + 1));
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < stretches; ++i)
    keep_extremes(curve, i * rows / stretches, (i + 1) * rows / stretches, kept);
  if (kept.back() != rows - 1) kept.push_back(rows - 1);
  return chosen_rows(curve, kept);
}

Curve simplify(const Curve& curve, const std::vector<double>& widths, double tolerance, bool colored) {
  const std::size_t rows = curve.size();
  if (rows < 3) return curve;
  std::vector<bool> kept(rows, false);
  kept.front() = kept.back() = true;
  const std::size_t axes = curve.columns.size() - (colored ? 1 : 0);
  keep_shape(curve, widths, axes, tolerance, kept);
  if (colored) keep_colors(curve.columns.back(), 40.0 * tolerance * widths.back(), kept);
  std::vector<std::size_t> chosen;
  for (std::size_t row = 0; row < rows; ++row)
    if (kept[row]) chosen.push_back(row);
  return chosen_rows(curve, chosen);
}

namespace {

std::vector<Curve> simplified(const std::vector<Curve>& curves, const std::vector<double>& widths,
                              double tolerance, bool colored) {
  std::vector<Curve> simple;
  for (const Curve& curve : curves) simple.push_back(simplify(curve, widths, tolerance, colored));
  return simple;
}

/// Thins curves that exceed the budget by shape alone: first to the extremes of ranges of rows, then with
/// increasing tolerances.
std::vector<Curve> coarse(std::vector<Curve> curves, const std::vector<double>& widths, std::size_t budget,
                          bool colored) {
  constexpr std::size_t max_rows = 6000;
  for (Curve& curve : curves) curve = decimate(curve, max_rows);
  for (double tolerance = unseen; tolerance < 0.1; tolerance *= 1.6) {
    curves = simplified(curves, widths, tolerance, colored);
    if (rows_of(curves) <= budget) break;
  }
  return curves;
}

}  // namespace

std::vector<Curve> thinned(const Curves& all, std::size_t group, std::size_t budget, bool colored) {
  if (all.logarithmic) return cut(all, group, budget);
  const std::vector<double> widths = widths_of(all);
  std::vector<Curve> dense;
  for (const Curve& curve : all.curves)
    if (curve.group == group) dense.push_back(sparser(curve, widths, near, colored));
  std::vector<Curve> curves;
  for (const double tolerance : {unseen, 2.0 * unseen}) {
    curves = simplified(dense, widths, tolerance, colored);
    if (rows_of(curves) <= budget) return curves;
  }
  const bool over_x = std::ranges::all_of(dense, ascends);
  if (!over_x && rows_of(curves) <= shape_excess * budget) return curves;
  return coarse(over_x ? of_group(all, group) : std::move(curves), widths, budget, colored);
}

std::vector<Curve> cut(const Curves& all, std::size_t group, std::size_t budget) {
  std::size_t rows = 0;
  for (const Curve& curve : all.curves)
    if (curve.group == group) rows += curve.size();
  std::vector<Curve> curves;
  for (const Curve& curve : all.curves) {
    if (curve.group != group) continue;
    const std::size_t share = rows <= budget ? curve.size() : budget * curve.size() / rows;
    curves.push_back(decimate(curve, std::max<std::size_t>(share, 8)));
  }
  return curves;
}

}  // namespace stepwire::geometry
