#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/base/math/instant.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Delay of a continuous signal by any time: y(t) = u(t - delay).
struct TransportDelay {
  enum class Between { smooth, linear, hold };
  static constexpr Index degree = 4;  ///< largest degree of the polynomial between samples

  double longest = 1.0;
  PerElement initial = 0.0;
  Between between = Between::smooth;
  Input<> u{};
  Input<1> delay{};
  Output<> y{};
  DiscreteState<> times{};    // Times of the rows of the ring buffer [s].
  DiscreteState<> samples{};  // Samples, one for each row.
  DiscreteState<> edges{};    // 1 at rows of instants, 2 and more at their echoes, else 0.
  DiscreteState<1> newest{};  // Index of the last written row.
  DiscreteState<1> count{};   // Number of written rows.
  DiscreteState<1> passed{};  // Time of the last row of an instant that has arrived [s]; -1 without one.
  Diagnostic out_of_range{}, full{};

  Index rows = 1;
  double most = 1.0;     // largest stored delay [s]
  bool changes = false;  // true if the delay is a signal
  Period period{};
  Time t{};

  void outputs() {
    const double T = length();
    const Index last = last_reached(T);
    for (Index i = 0; i < y.size(); ++i) y[i] = last < 0 ? initial[i] : value(i, last, t - T);
  }

  void update() {
    if (!(delay >= shortest() && delay <= most)) out_of_range.raise(t);
    store(false);
    if (changes) pass();
  }
  void update_at_event() {
    store(true);
    if (changes) pass();
  }

  /// Returns the time at which the next instant arrives. With a delay that changes, a crossing finds it.
  double next_edge() const {
    const double T = length();
    for (Index row = last_reached(T) + 1; !changes && row < known(); ++row)
      if (edges[place(row)] > 0.0) return times[place(row)] + T;
    return std::numeric_limits<double>::infinity();
  }

  void crossings(Crossings& zero) const {
    Index row = 0;
    while (row < known() && !(edges[place(row)] > 0.0 && times[place(row)] > passed)) ++row;
    zero.add(row < known() ? t - length() - times[place(row)] : -1.0);
  }

  void start() { passed = -1.0; }

  void configure(Configure& is);
  static void declare(Declare<TransportDelay>& is);

 private:
  /// Returns the shortest delay: one step, with a margin for rounding, since a stage reads rows up to the
  /// last tick.
  double shortest() const { return period * (1.0 - 1e-9); }
  double length() const { return std::clamp(double(delay), shortest(), std::max(most, shortest())); }

  Index known() const { return static_cast<Index>(count); }
  /// Returns the index of a row in the ring buffer; row 0 is the oldest.
  Index place(Index row) const {
    const Index at = static_cast<Index>(newest) - (known() - 1 - row);
    return at < 0 ? at + rows : at;
  }
  double sample(Index row, Index i) const { return samples[place(row) * u.size() + i]; }

  /// Returns the last row that the delayed time has reached; -1 without one.
  Index last_reached(double T) const {
    Index low = -1, high = known();
    while (high - low > 1) {
      const Index middle = low + (high - low) / 2;
      (reached(t, times[place(middle)] + T) ? low : high) = middle;
    }
    return low;
  }

  /// Stores the last instant that has arrived.
  void pass() {
    for (Index row = last_reached(length()); row >= 0 && times[place(row)] > passed; --row)
      if (edges[place(row)] > 0.0) passed = times[place(row)];
  }

  double value(Index i, Index row, double at) const {
    if (between == Between::hold || row + 1 >= known()) return sample(row, i);
    if (between == Between::smooth) return smooth(i, row, at);
    const double from = times[place(row)], to = times[place(row + 1)];
    return sample(row, i) + (at - from) / (to - from) * (sample(row + 1, i) - sample(row, i));
  }

  struct Newton {
    static constexpr double none = std::numeric_limits<double>::infinity();

    Index begin = 0, order = 0;
    double value = 0.0, last_term = none;
    double roughness = none;  ///< last term for evenly spaced rows
  };

  /// Interpolates by Newton's polynomial through nearby rows.
  ///
  /// The stencil with the smallest last term is used, so that it does not cross a jump or a kink (ENO;
  /// Harten, Engquist, Osher, Chakravarthy 1987). There are two kinds: stencils that reach beyond `row`, and
  /// stencils that end at `row` and extrapolate, up to a jump at the next row. The latter may have fewer
  /// rows, after another jump. At a kink in `row` itself both kinds are smooth. Then the stencil that
  /// contains the next row is right: the other one misses that row by far more than the roughness of the
  /// rows.
  double smooth(Index i, Index row, double at) const {
    const Index order = std::min(degree, known() - 1);
    Newton across, up_to;
    const auto try_from = [&](Index begin, Index terms) {
      const Newton made = newton(i, begin, terms, at);
      Newton& best = begin + terms > row ? across : up_to;
      if (made.last_term < best.last_term) best = made;
    };
    for (Index begin = std::min(row, known() - 1 - order); begin >= std::max<Index>(row - order, 0); --begin)
      try_from(begin, order);
    for (Index terms = std::min(order, row); terms > 0; --terms) try_from(row - terms, terms);
    for (Index terms = std::min(order, known() - 1 - row); terms > 0; --terms) try_from(row, terms);
    if (is_alone(i, row, across)) return sample(row, i);
    if (!(up_to.last_term < across.last_term)) return across.value;
    const double next = newton(i, up_to.begin, up_to.order, times[place(row + 1)]).value;
    return across.roughness < 0.01 * std::abs(next - sample(row + 1, i)) ? across.value : up_to.value;
  }

  /// True if a row is isolated by jumps. Either there are a jump in `row` and one at the next row, so that
  /// only a straight line fits. Or `row` is the first one and the later rows extrapolate to another value.
  bool is_alone(Index i, Index row, const Newton& across) const {
    if (row > 0) return across.order == 1 && edges[place(row)] > 0.0 && edges[place(row + 1)] > 0.0;
    const Index terms = std::min(degree, known() - 2);
    if (terms < 1) return edges[place(1)] > 0.0;
    const Newton back = newton(i, 1, terms, times[place(0)]);
    return std::abs(back.value - sample(0, i)) > 100.0 * back.roughness + 1e-9 * std::abs(sample(0, i));
  }

  Newton newton(Index i, Index begin, Index order, double at) const {
    std::array<double, degree + 1> x{}, d{};
    for (Index k = 0; k <= order; ++k) {
      x[static_cast<std::size_t>(k)] = times[place(begin + k)];
      d[static_cast<std::size_t>(k)] = sample(begin + k, i);
    }
    const auto n = static_cast<std::size_t>(order);
    for (std::size_t k = 1; k <= n; ++k)
      for (std::size_t j = n; j >= k; --j) d[j] = (d[j] - d[j - 1]) / (x[j] - x[j - k]);
    const double step = (x[n] - x[0]) / static_cast<double>(std::max<Index>(order, 1));
    double value = d[n], last_term = d[n], roughness = std::abs(d[n]);
    for (std::size_t k = n; k-- > 0;) {
      value = d[k] + (at - x[k]) * value;
      last_term *= at - x[k];
      roughness *= step;
    }
    return {begin, order, value, std::abs(last_term), roughness};
  }

  /// Writes a row; overwrites the last one if it has the same time.
  void store(bool at_event) {
    const bool again = known() > 0 && times[static_cast<Index>(newest)] == t;
    if (!again) {
      const Index next = known() == 0 ? 0 : (static_cast<Index>(newest) + 1) % rows;
      if (known() == rows && !reached(t, times[(next + 1) % rows] + most)) full.raise(t);
      newest = static_cast<double>(next);
      count = std::min(count + 1.0, static_cast<double>(rows));
      times[next] = t;
      edges[next] = 0.0;
    }
    const Index at = static_cast<Index>(newest);
    if (at_event || has_jumped()) edges[at] = at_event ? static_cast<double>(order_of_instant()) : 1.0;
    for (Index i = 0; i < u.size(); ++i) samples[at * u.size() + i] = u[i];
  }

  /// Returns 1 for an instant of another block. In a loop, an instant that this block has delayed returns to
  /// it, each time with one more smooth derivative. From the sixth time on it is no edge, and the result is
  /// 0.
  Index order_of_instant() const {
    constexpr double most_echoes = 5.0;
    const double T = length();
    for (Index row = last_reached(T); row >= 0 && times[place(row)] + T > t - 1e-6 * period; --row)
      if (edges[place(row)] > 0.0 && !has_jumped())
        return edges[place(row)] < most_echoes ? static_cast<Index>(edges[place(row)]) + 1 : 0;
    return 1;
  }

  /// True if the input is far off the line through the last two rows.
  bool has_jumped() const {
    const Index last = known() - 2;  // before the row of this time
    if (last < 1) return true;
    const double from = times[place(last - 1)], to = times[place(last)];
    for (Index i = 0; i < u.size(); ++i) {
      const double here = sample(last, i), slope = (here - sample(last - 1, i)) / (to - from);
      const double moved = std::abs(u[i] - here), expected = std::abs(slope * (t - to));
      if (moved > 10.0 * expected + 1e-9 * std::abs(here)) return true;
    }
    return false;
  }
};

}  // namespace stepwire
