#include "engine/analyse/claim/step_reductions.hpp"

#include <algorithm>
#include <cmath>

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

}  // namespace stepwire::claim
