#include "engine/analyse/claim/reduce.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/analyse/claim/step_reductions.hpp"
#include "engine/analyse/statistics/quartiles.hpp"
#include "engine/analyse/statistics/rank.hpp"

namespace stepwire::claim {
namespace {

std::vector<double> selected(const std::vector<double>& values, const Rows& rows) {
  std::vector<double> result;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (rows.selected[i]) result.push_back(values[i]);
  return result;
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// A nan among the values is the answer: what cannot be compared must not win or lose.
double extreme(const std::vector<double>& values, bool largest) {
  double result = values.front();
  for (const double value : values) {
    if (std::isnan(value)) return query::nothing;
    result = largest ? std::max(result, value) : std::min(result, value);
  }
  return result;
}

/// Calls visit(i, i + 1) for neighbouring rows of one run that are both selected.
template <class Visit>
void for_each_interval(const Rows& rows, Visit visit) {
  for (std::size_t run = 0; run < rows.starts.size(); ++run)
    for (std::size_t i = rows.starts[run]; i + 1 < rows.run_end(run); ++i)
      if (rows.selected[i] && rows.selected[i + 1]) visit(i, i + 1);
}

double squared_if(double value, bool squared) {
  return squared ? value * value : value;
}

/// Mean over time of the value or its square, by the trapezoid rule.
double time_mean(const Rows& rows, bool squared) {
  double integral = 0.0, duration = 0.0;
  for_each_interval(rows, [&](std::size_t i, std::size_t j) {
    const double step = rows.time[j] - rows.time[i];
    integral += 0.5 * step * (squared_if(rows.value[i], squared) + squared_if(rows.value[j], squared));
    duration += step;
  });
  if (duration > 0.0) return integral / duration;
  // Single rows have no duration: each counts the same.
  std::vector<double> values = selected(rows.value, rows);
  for (double& value : values) value = squared_if(value, squared);
  return mean_of(values);
}

double fraction(const std::vector<double>& values) {
  std::size_t count = 0;
  for (const double value : values) {
    if (std::isnan(value)) return query::nothing;
    if (value != 0.0) ++count;
  }
  return static_cast<double>(count) / static_cast<double>(values.size());
}

double quantile(std::vector<double> values, double share) {
  if (std::ranges::any_of(values, [](double value) { return std::isnan(value); })) return query::nothing;
  std::ranges::sort(values);
  return statistics::hazen_quantile(values, share);
}

double rising_edges(const Rows& rows) {
  double count = 0.0;
  for (std::size_t i = 0; i < rows.value.size(); ++i)
    if (rows.selected[i] && std::isnan(rows.value[i])) return query::nothing;
  for_each_interval(rows, [&](std::size_t i, std::size_t j) {
    if (rows.value[i] == 0.0 && rows.value[j] != 0.0) count += 1.0;
  });
  return count;
}

/// 100 (1 - |model - measured| / |measured - mean|).
double fit_percent(std::vector<double> model, const std::vector<double>& measured, bool free_offset) {
  const double mean = mean_of(measured);
  if (free_offset) {
    const double offset = mean - mean_of(model);
    for (double& value : model) value += offset;
  }
  double error = 0.0, variation = 0.0;
  for (std::size_t i = 0; i < model.size(); ++i) {
    error += (model[i] - measured[i]) * (model[i] - measured[i]);
    variation += (measured[i] - mean) * (measured[i] - mean);
  }
  return variation > 0.0 ? 100.0 * (1.0 - std::sqrt(error / variation)) : query::nothing;
}

}  // namespace

Rows Rows::of_run(std::size_t run) const {
  const auto piece = [&](const auto& all) {
    using List = std::remove_cvref_t<decltype(all)>;
    if (all.empty()) return List{};
    return List(all.begin() + static_cast<std::ptrdiff_t>(starts[run]),
                all.begin() + static_cast<std::ptrdiff_t>(run_end(run)));
  };
  return {piece(value), piece(other), piece(time), piece(selected), {0}, free_offset, share};
}

double reduce(Reduction reduction, const Rows& rows) {
  if (is_of_step(reduction)) return reduce_step(reduction, rows);
  const std::vector<double> values = selected(rows.value, rows);
  switch (reduction) {
    case Reduction::max:
    case Reduction::min:
      return extreme(values, reduction == Reduction::max);
    case Reduction::spread:
      return extreme(values, true) - extreme(values, false);
    case Reduction::mean:
    case Reduction::rms:
      return reduction == Reduction::rms ? std::sqrt(time_mean(rows, true)) : time_mean(rows, false);
    case Reduction::fraction:
      return fraction(values);
    case Reduction::count:
      return rising_edges(rows);
    case Reduction::quantile:
      return quantile(values, rows.share);
    case Reduction::rising:
      return statistics::rank_correlation(values, selected(rows.other, rows));
    case Reduction::fit:
      return fit_percent(values, selected(rows.other, rows), rows.free_offset);
    default:
      break;
  }
  return query::nothing;
}

}  // namespace stepwire::claim
