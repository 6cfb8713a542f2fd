#pragma once

#include "engine/model/block/resettable.hpp"

namespace stepwire {

/// Mean of the samples in a window that ends now.
struct MovingAverage : ResetInput {
  double window = 0.0;
  Input<> u{};
  Output<> y{};
  DiscreteState<> samples{};  // Ring buffer with a row for each sample.
  DiscreteState<> sum{};      // Sum of the samples in the window, without the present one.
  DiscreteState<> fresh{};    // Sum of the samples since the ring buffer last wrapped.
  DiscreteState<1> row{};     // Next row to be written.
  DiscreteState<1> count{};   // Number of samples so far, up to a full window.

  Index length = 1;

  void outputs() {
    if (resetting()) {
      y = u;
      return;
    }
    const double seen = is_full() ? count : count + 1.0;
    for (Index i = 0; i < y.size(); ++i) y[i] = with_new(i) / seen;
  }

  void update() {
    if (resetting()) forget();
    remember_reset();
    const Index here = static_cast<Index>(row);
    const bool closes = here + 1 == length;
    for (Index i = 0; i < u.size(); ++i) {
      // Adding and subtracting accumulates rounding errors, so the sum is recomputed at each wrap.
      const double together = fresh[i] + u[i];
      sum[i] = closes ? together : with_new(i);
      fresh[i] = closes ? 0.0 : together;
      samples[here * u.size() + i] = u[i];
    }
    row = closes ? 0.0 : static_cast<double>(here + 1);
    if (!is_full()) count = count + 1.0;
  }

  void configure(Configure& is);
  static void declare(Declare<MovingAverage>& is);

 private:
  bool is_full() const { return count >= static_cast<double>(length); }
  void forget() {
    samples = 0.0;
    sum = 0.0;
    fresh = 0.0;
    row = 0.0;
    count = 0.0;
  }
  /// Returns the sum with the present sample in place of the one that leaves (0 while the window fills).
  double with_new(Index i) const { return sum[i] - samples[static_cast<Index>(row) * u.size() + i] + u[i]; }
};

}  // namespace stepwire
