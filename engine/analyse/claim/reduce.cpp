#include "engine/analyse/claim/reduce.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/analyse/statistics/descriptive.hpp"

namespace stepwire::claim {
namespace {

constexpr double rise_from = 0.1, rise_to = 0.9;  // shares of the final change
constexpr double band = 0.02;                     // around the final value, as a share of the final change

/// Selected rows of a run: seconds since the first one, and values scaled to 0 at the first and 1 at the
/// last.
struct Way {
  std::vector<double> time, share;
};

Way way_of(const Rows& rows) {
  Way way;
  for (std::size_t i = 0; i < rows.value.size(); ++i) {
    if (!rows.selected[i]) continue;
    way.time.push_back(rows.time[i]);
    way.share.push_back(rows.value[i]);
  }
  const double start = way.time.front(), first = way.share.front(), whole = way.share.back() - first;
  for (double& time : way.time) time -= start;
  for (double& share : way.share) share = whole != 0.0 ? (share - first) / whole : query::nothing;
  return way;
}

/// Returns the time at which a share is first reached.
double reached(const Way& way, double share) {
  for (std::size_t i = 0; i < way.share.size(); ++i) {
    if (way.share[i] < share) continue;
    if (i == 0) return way.time[0];
    const double part = (share - way.share[i - 1]) / (way.share[i] - way.share[i - 1]);
    return way.time[i - 1] + part * (way.time[i] - way.time[i - 1]);
  }
  return query::nothing;
}

/// Returns the time from which the signal stays within the band.
double settled(const Way& way) {
  for (std::size_t i = way.share.size(); i-- > 0;) {
    const double away = std::abs(way.share[i] - 1.0);
    if (away <= band) continue;
    if (i + 1 == way.share.size()) return query::nothing;
    const double next = std::abs(way.share[i + 1] - 1.0), part = (away - band) / (away - next);
    return way.time[i] + part * (way.time[i + 1] - way.time[i]);
  }
  return 0.0;
}

double absolute_integral(const Rows& rows) {
  double integral = 0.0;
  for (std::size_t i = 0; i + 1 < rows.value.size(); ++i)
    if (rows.selected[i] && rows.selected[i + 1])
      integral +=
          0.5 * (rows.time[i + 1] - rows.time[i]) * (std::abs(rows.value[i]) + std::abs(rows.value[i + 1]));
  return integral;
}

double last_selected(const Rows& rows) {
  for (std::size_t i = rows.value.size(); i-- > 0;)
    if (rows.selected[i]) return rows.value[i];
  return query::nothing;
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Calls visit(i, i + 1) for neighbouring rows of one run that are both selected.
template <class Visit>
void for_each_interval(const Rows& rows, Visit visit) {
  for (std::size_t run = 0; run < rows.starts.size(); ++run)
    for (std::size_t i = rows.starts[run]; i + 1 < rows.run_end(run); ++i)
      if (rows.selected[i] && rows.selected[i + 1]) visit(i, i + 1);
}

double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return statistics::hazen_quantile(values, share);
}

/// Returns 100 (1 - |model - measured| / |measured - mean|).
double fit_percent(std::vector<double> model, const std::vector<double>& measured, bool free_offset) {
  const double mean = mean_of(measured);
  if (free_offset) {
    const double offset = mean - mean_of(model);
    for (double& value : model) value += offset;
  }
  SumOfSquares error, variation;
  for (std::size_t i = 0; i < model.size(); ++i) {
    error.add(model[i] - measured[i]);
    variation.add(measured[i] - mean);
  }
  if (!(variation.scaled() > 0.0)) return query::nothing;
  const bool alike = error.scale() == variation.scale();
  return 100.0 *
         (1.0 - (alike ? std::sqrt(error.scaled() / variation.scaled()) : error.root() / variation.root()));
}

}  // namespace

bool is_of_step(Reduction reduction) {
  return reduction >= Reduction::overshoot && reduction <= Reduction::steady_error;
}

double reduce_step(Reduction reduction, const Rows& rows) {
  if (reduction == Reduction::iae) return absolute_integral(rows);
  if (reduction == Reduction::steady_error) return std::abs(last_selected(rows));
  const Way way = way_of(rows);
  if (std::ranges::any_of(way.share, [](double share) { return std::isnan(share); })) return query::nothing;
  const auto peak = std::ranges::max_element(way.share);
  switch (reduction) {
    case Reduction::overshoot:
      return std::max(0.0, *peak - 1.0);
    case Reduction::rise_time:
      return reached(way, rise_to) - reached(way, rise_from);
    case Reduction::settling_time:
      return settled(way);
    default:
      return way.time[static_cast<std::size_t>(peak - way.share.begin())];
  }
}

Rows Rows::of_run(std::size_t run) const {
  const auto piece = [&](const auto& all) {
    using List = std::remove_cvref_t<decltype(all)>;
    if (all.empty()) return List{};
    return List(all.begin() + static_cast<std::ptrdiff_t>(starts[run]),
                all.begin() + static_cast<std::ptrdiff_t>(run_end(run)));
  };
  return {piece(value), piece(other), piece(time), piece(selected), {0}, free_offset, share};
}

bool keeps_rows(Reduction reduction) {
  return reduction == Reduction::quantile || reduction == Reduction::rising || reduction == Reduction::fit;
}

void Reducing::add(const Rows& rows) {
  free_offset_ = rows.free_offset;
  share_ = rows.share;
  if (reduction_ == Reduction::count) add_edges(rows);
  if (reduction_ == Reduction::mean || reduction_ == Reduction::rms) add_times(rows);
  for (std::size_t row = 0; row < rows.value.size(); ++row) {
    if (!rows.selected[row]) continue;
    take(rows.value[row]);
    if (!keeps_rows(reduction_)) continue;
    values_.push_back(rows.value[row]);
    if (!rows.other.empty()) others_.push_back(rows.other[row]);
  }
}

/// Adds a value. A nan makes the result nan: without a defined order it must neither win nor lose.
void Reducing::take(double value) {
  undefined_ = undefined_ || std::isnan(value);
  largest_ = all_ == 0 ? value : std::max(largest_, value);
  smallest_ = all_ == 0 ? value : std::min(smallest_, value);
  ++all_;
  if (reduction_ == Reduction::mean) sum_ += value;
  if (reduction_ == Reduction::rms) square_sum_.add(value);
  if (reduction_ == Reduction::fraction && value != 0.0) ++counted_;
}

void Reducing::add_edges(const Rows& rows) {
  for_each_interval(rows, [&](std::size_t i, std::size_t j) {
    if (rows.value[i] == 0.0 && rows.value[j] != 0.0) ++counted_;
  });
}

/// Integrates by the trapezoid rule.
void Reducing::add_times(const Rows& rows) {
  for_each_interval(rows, [&](std::size_t i, std::size_t j) {
    const double step = rows.time[j] - rows.time[i];
    integral_ += 0.5 * step * (rows.value[i] + rows.value[j]);
    square_integral_.add(rows.value[i], rows.value[j], 0.5 * step);
    duration_ += step;
  });
}

/// Returns the mean over time. Single rows have no duration and count equally.
double Reducing::time_mean() const {
  return duration_ > 0.0 ? integral_ / duration_ : sum_ / static_cast<double>(all_);
}

double Reducing::rms() const {
  return duration_ > 0.0 ? square_integral_.root(duration_) : square_sum_.root(static_cast<double>(all_));
}

double Reducing::value() const {
  if (reduction_ == Reduction::mean) return time_mean();
  if (reduction_ == Reduction::rms) return rms();
  if (undefined_) return query::nothing;
  switch (reduction_) {
    case Reduction::max:
      return largest_;
    case Reduction::min:
      return smallest_;
    case Reduction::spread:
      return largest_ - smallest_;
    case Reduction::fraction:
      return static_cast<double>(counted_) / static_cast<double>(all_);
    case Reduction::count:
      return static_cast<double>(counted_);
    case Reduction::quantile:
      return quantile(values_, share_);
    case Reduction::rising:
      return statistics::rank_correlation(values_, others_);
    case Reduction::fit:
      return fit_percent(values_, others_, free_offset_);
    default:
      return query::nothing;
  }
}

double reduce(Reduction reduction, const Rows& rows) {
  if (is_of_step(reduction)) return reduce_step(reduction, rows);
  Reducing reducing(reduction);
  reducing.add(rows);
  return reducing.value();
}

}  // namespace stepwire::claim
