#pragma once

#include <algorithm>
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
  DiscreteState<> times{};         // Times of the rows of the ring buffer [s].
  DiscreteState<> samples{};       // Samples, one for each row.
  DiscreteState<> left_samples{};  // The same just before the instant of the row.
  DiscreteState<> left{};          // Input just before the present instant.
  DiscreteState<1> left_time{};    // Present instant, or the last one before the block was off [s].
  DiscreteState<> edges{};         // 1 at rows of instants, 2 and more at their echoes, else 0; or resumed.
  DiscreteState<1> newest{};       // Index of the last written row.
  DiscreteState<1> count{};        // Number of written rows.
  DiscreteState<1> newest_edge{};  // Time of the newest row of an instant [s]; -1 without one.
  DiscreteState<1> passed{};       // Time of the last row of an instant that has arrived [s]; -1 without one.
  Diagnostic out_of_range{}, full{};

  Index rows = 1;
  double most = 1.0;          // largest stored delay [s]
  bool changes = false;       // true if the delay is a signal
  bool holds_passed = false;  // Between instants the output keeps its side of each jump.
  Period period{};
  Time t{};

  void outputs() { pass_on(holds_passed ? last_passed() : last_reached(length())); }
  void outputs_at_instant() { pass_on(last_reached(length())); }

  void update_before_instant() {
    for (Index i = 0; i < u.size(); ++i) left[i] = u[i];
    left_time = t;
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

  /// Adds the times since the next instant and the last one that has arrived. A delay that grows by more than
  /// the time goes back behind the last one.
  void crossings(Crossings& zero) const {
    const Index row = next_instant();
    const double T = length();
    zero.add(row < known() ? time_since(times[place(row)] + T, t) : -1.0);
    zero.add(passed >= 0.0 ? t - T - passed + 1e-9 * period : 1.0);
  }

  void start() {
    left_time = -1.0;
    newest_edge = -1.0;
    passed = -1.0;
  }

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
  double left_sample(Index row, Index i) const { return left_samples[place(row) * u.size() + i]; }

  /// Returns the last row that the delayed time has reached; -1 without one.
  Index last_reached(double T) const {
    Index low = -1, high = known();
    while (high - low > 1) {
      const Index middle = low + (high - low) / 2;
      (reached(t, times[place(middle)] + T) ? low : high) = middle;
    }
    return low;
  }

  void pass_on(Index row) {
    const double at = t - length();
    for (Index i = 0; i < y.size(); ++i) y[i] = row < 0 ? initial[i] : value(i, row, at);
  }

  /// Returns the first row of an instant that has not arrived; the number of rows without one.
  Index next_instant() const {
    Index row = newest_edge > passed ? first_after(passed) : known();
    while (row < known() && !(edges[place(row)] > 0.0)) ++row;
    return row;
  }
  /// Returns the last row that the delayed time has reached, between the last instant that has arrived and
  /// the next one.
  Index last_passed() const {
    const Index reached = std::min(last_reached(length()), next_instant() - 1);
    return passed >= 0.0 ? std::max(reached, first_after(passed) - 1) : reached;
  }

  /// Returns the first row after a time; the number of rows without one.
  Index first_after(double time) const {
    Index low = -1, high = known();
    while (high - low > 1) {
      const Index middle = low + (high - low) / 2;
      (times[place(middle)] > time ? high : low) = middle;
    }
    return high;
  }

  /// Stores the last instant that has arrived.
  void pass() {
    Index row = last_reached(length());
    const bool forward = row >= 0 && times[place(row)] >= passed;
    if (!forward) passed = -1.0;
    for (; row >= 0 && times[place(row)] > passed; --row)
      if (edges[place(row)] > 0.0) passed = times[place(row)];
  }

  /// Value of `edges` at the first row after the block was off.
  static constexpr double resumed = 0.5;
  bool follows_gap(Index row) const { return edges[place(row)] == resumed; }

  /// True if an element differs by more than rounding before and after the instant of a row, other than the
  /// oldest one, or if the block was off before it.
  bool jumps(Index row, Index i) const {
    if (follows_gap(row)) return true;
    const double here = left_sample(row, i), then = sample(row, i);
    return std::abs(then - here) > 1e-9 * (std::abs(then) + std::abs(here - sample(row - 1, i)));
  }

  /// Interpolates between a row and the next one by Newton's polynomials through nearby rows.
  ///
  /// The stencil with the smallest last term is used, so that it does not cross a bend (ENO; Harten,
  /// Engquist, Osher, Chakravarthy 1987). No stencil reaches beyond a jump.
  double value(Index i, Index row, double at) const {
    if (between == Between::hold || row + 1 >= known() || follows_gap(row + 1)) return sample(row, i);
    const Index order = between == Between::linear ? 1 : degree;
    return smoothest(nodes(i, row, order), order, at).value;
  }

  /// Rows around an interval as points of a curve.
  struct Nodes {
    double x[2 * degree]{}, f[2 * degree]{};
    Index begin = degree - 1, end = degree + 1;  ///< The interval is from node degree - 1 to the next.

    void put(Index node, double time, double value) {
      x[node] = time;
      f[node] = value;
    }
  };

  /// Returns the rows around an interval, at most `order` - 1 more on each side. They end at jumps. They also
  /// end at instants, where the curve may bend, if enough rows for the highest degree are between two.
  Nodes nodes(Index i, Index row, Index order) const {
    Nodes made;
    made.put(degree - 1, times[place(row)], sample(row, i));
    made.put(degree, times[place(row + 1)], left_sample(row + 1, i));
    const Index begin = extend_back(made, i, row, order), end = extend_forward(made, i, row + 1, order);
    if (end - begin > degree) {
      made.begin = begin;
      made.end = end;
    }
    return made;
  }

  /// Adds the rows before a row, but for those within rounding of the next one. Returns the node of the last
  /// instant.
  Index extend_back(Nodes& made, Index i, Index row, Index order) const {
    const double close = 1e-6 * (made.x[degree] - made.x[degree - 1]);
    Index instant = -1;
    for (; row > 0 && !jumps(row, i) && made.begin > degree - order; --row) {
      if (instant < 0 && edges[place(row)] > 0.0) instant = made.begin;
      const double time = times[place(row - 1)];
      if (made.x[made.begin] - time > close) made.put(--made.begin, time, sample(row - 1, i));
    }
    return instant < 0 ? made.begin : instant;
  }

  /// Adds the rows after a row likewise. Returns the node after the next instant.
  Index extend_forward(Nodes& made, Index i, Index row, Index order) const {
    const double close = 1e-6 * (made.x[degree] - made.x[degree - 1]);
    Index instant = -1;
    for (; row + 1 < known() && !jumps(row, i) && made.end < degree + order; ++row) {
      if (instant < 0 && edges[place(row)] > 0.0) instant = made.end;
      const double time = times[place(row + 1)];
      if (time - made.x[made.end - 1] > close) made.put(made.end++, time, left_sample(row + 1, i));
    }
    return instant < 0 ? made.end : instant;
  }

  struct Newton {
    double value = 0.0;
    /// Last term, which counts less towards the middle of the stencil, and a part of the one before it, since
    /// a single one may be 0 across a bend.
    double roughness = std::numeric_limits<double>::infinity();

    bool operator<(const Newton& other) const { return roughness < other.roughness; }
  };

  static Newton smoothest(const Nodes& nodes, Index most, double at) {
    most = std::min(most, nodes.end - nodes.begin - 1);
    Newton best;
    for (Index order = std::min<Index>(most, 2); order <= most; ++order)
      for (Index begin = std::max(nodes.begin, degree - order); begin < degree && begin + order < nodes.end;
           ++begin)
        best = std::min(best, newton(nodes, begin, order, at));
    return best;
  }

  static Newton newton(const Nodes& nodes, Index begin, Index order, double at) {
    const double* const x = nodes.x + begin;
    double d[degree + 1]{};
    std::copy_n(nodes.f + begin, order + 1, d);
    for (Index k = 1; k <= order; ++k)
      for (Index j = order; j >= k; --j) d[j] = (d[j] - d[j - 1]) / (x[j] - x[j - k]);
    double value = d[order], last = d[order], before = d[order - 1];
    for (Index k = order; k-- > 0;) {
      value = d[k] + (at - x[k]) * value;
      last *= at - x[k];
      if (k + 1 < order) before *= at - x[k];
    }
    const double next = (x[order] - at) / (x[order] - x[0]);
    return {value, std::abs(last * next) + 0.01 * std::abs(before)};
  }

  /// Writes the row of the present instant. After the block was off, a row of what it saw last precedes it.
  void store(bool at_event) {
    const double close = 1e-6 * period;  // The left side is seen a little before an instant.
    const bool was_off = known() > 0 && t - left_time > close && newest_time() < t;
    if (was_off && left_time - newest_time() > close) write(left_time, left, left);
    was_off ? write(t, u, u) : write(t, u, left);
    const Index at = static_cast<Index>(newest);
    if (was_off)
      edges[at] = resumed;
    else if (!follows_gap(known() - 1))
      edges[at] = at_event                       ? static_cast<double>(order_of_instant())
                  : known() == 1 || has_jumped() ? 1.0
                                                 : 0.0;
    if (edges[at] > 0.0) newest_edge = t;
    if (known() > 1 && edges[place(known() - 2)] == 0.0 && has_bent()) {
      edges[place(known() - 2)] = 1.0;
      newest_edge = std::max<double>(newest_edge, times[place(known() - 2)]);
    }
  }
  double newest_time() const { return times[static_cast<Index>(newest)]; }

  /// Writes a row; overwrites the last one if it has the same time.
  template <class Values, class LeftValues>
  void write(double time, const Values& values, const LeftValues& left_values) {
    if (known() == 0 || newest_time() != time) {
      if (known() == rows && !reached(t, times[place(1)] + most) && !thin()) full.raise(t);
      newest = known() == 0 ? 0.0 : static_cast<double>((static_cast<Index>(newest) + 1) % rows);
      count = std::min(count + 1.0, static_cast<double>(rows));
      times[static_cast<Index>(newest)] = time;
      edges[static_cast<Index>(newest)] = 0.0;
    }
    const Index at = static_cast<Index>(newest) * u.size();
    for (Index i = 0; i < u.size(); ++i) {
      samples[at + i] = values[i];
      left_samples[at + i] = left_values[i];
    }
  }

  /// Removes rows of instants that the rows around reproduce, such as those of other blocks' events. Returns
  /// false if fewer than 50 rows are left free by it.
  bool thin() {
    Index kept = 1;
    for (Index row = 1; row < known(); ++row)
      if (!is_redundant(row, kept)) copy(row, kept++);
    const bool enough = known() - kept >= 50;
    newest = static_cast<double>(place(kept - 1));
    count = static_cast<double>(kept);
    return enough;
  }
  /// True if the row is that of an instant, and a polynomial through two rows on each side has its samples.
  /// The rows before it have been moved to the first `kept` ones.
  bool is_redundant(Index row, Index kept) const {
    if (!(edges[place(row)] > 0.0) || kept < 2 || row + 2 >= known()) return false;
    const Index around[] = {kept - 2, kept - 1, row + 1, row + 2};
    for (Index i = 0; i < u.size(); ++i) {
      for (const Index other : {kept - 1, row, row + 1, row + 2})
        if (jumps(other, i)) return false;
      double value = 0.0, size = 0.0;
      for (const Index k : around) {
        double weight = 1.0;
        for (const Index j : around)
          if (j != k) weight *= (times[place(row)] - times[place(j)]) / (times[place(k)] - times[place(j)]);
        value += weight * sample(k, i);
        size = std::max(size, std::abs(sample(k, i)));
      }
      if (!(std::abs(value - sample(row, i)) <= 1e-9 * size)) return false;
    }
    return true;
  }
  void copy(Index from, Index to) {
    const Index source = place(from), target = place(to);
    if (source == target) return;
    times[target] = static_cast<double>(times[source]);
    edges[target] = static_cast<double>(edges[source]);
    for (Index i = 0; i < u.size(); ++i) {
      samples[target * u.size() + i] = static_cast<double>(samples[source * u.size() + i]);
      left_samples[target * u.size() + i] = static_cast<double>(left_samples[source * u.size() + i]);
    }
  }

  /// Returns 1 for an instant of another block. In a loop, an instant that this block has delayed returns to
  /// it, each time with one more smooth derivative. From the sixth time on it is no edge, and the result is
  /// 0.
  Index order_of_instant() const {
    constexpr double most_echoes = 5.0;
    const double T = length();
    const Index next = std::min(last_reached(T) + 1, known() - 1);  // arrives back if the delay grows
    for (Index row = next; row >= 0 && times[place(row)] + T > t - 1e-6 * period; --row)
      if (edges[place(row)] > 0.0 && times[place(row)] + T < t + 1e-6 * period && !has_jumped())
        return edges[place(row)] < most_echoes ? static_cast<Index>(edges[place(row)]) + 1 : 0;
    return 1;
  }

  bool has_jumped() const {
    for (Index i = 0; known() > 1 && i < u.size(); ++i)
      if (jumps(known() - 1, i)) return true;
    return false;
  }

  /// True if the newest row shows that the slope or the curvature of the input jumps at the row before it:
  /// its second or third difference is far larger than the two before it. A polynomial of degree 4 across
  /// such an instant, and a step of a solver across its arrival, would have an error of the third order or a
  /// lower one.
  bool has_bent() const {
    for (Index i = 0; i < u.size(); ++i)
      if (grows(i, 2) || grows(i, 3)) return true;
    return false;
  }
  bool grows(Index i, Index order) const {
    if (known() < order + 3) return false;
    for (Index row = known() - 2; row > known() - order - 2; --row)
      if (jumps(row, i) || times[place(row + 1)] - times[place(row)] < 1e-6 * period) return false;
    const double here = difference(known() - 1, i, order);
    const double before = std::max(difference(known() - 2, i, order), difference(known() - 3, i, order));
    const double h = t - times[place(known() - 2)], size = here * h * h * (order > 2 ? h : 1.0);
    return here > 5.0 * before && size > 1e-9 * std::abs(sample(known() - 2, i));
  }
  /// Returns the size of the divided difference of the rows up to this one.
  double difference(Index last, Index i, Index order) const {
    double d[4]{};
    for (Index k = 0; k <= order; ++k) d[k] = k < order ? sample(last - order + k, i) : left_sample(last, i);
    for (Index k = 1; k <= order; ++k)
      for (Index j = order; j >= k; --j)
        d[j] = (d[j] - d[j - 1]) / (times[place(last - order + j)] - times[place(last - order + j - k)]);
    return std::abs(d[order]);
  }
};

}  // namespace stepwire
