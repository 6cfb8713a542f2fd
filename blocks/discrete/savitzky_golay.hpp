#pragma once

#include <cstdint>

#include "engine/model/block/resettable.hpp"
#include "engine/model/signal/numbers.hpp"

namespace stepwire {

/// Value or derivative at the centre of a window, of the polynomial of least squares through its samples.
struct SavitzkyGolay : ResetInput {
  std::int64_t window = 5, order = 2, derivative = 0;
  Input<> u{};
  Output<> y{};
  DiscreteState<> samples{};  // ring buffer of the samples in the window, without the present one
  DiscreteState<1> oldest{};  // row of the first sample of the window
  DiscreteState<1> begun{};   // 0 at the first tick, then 1

  Numbers coefficients;  // of the samples of the window, the oldest first

  void outputs() {
    const Index before = coefficients.size() - 1;
    const bool filled = begun > 0.0 && !resetting();
    for (Index i = 0; i < y.size(); ++i) y[i] = coefficients[before] * u[i];
    Index row = static_cast<Index>(oldest);
    for (Index k = 0; k < before; ++k) {
      for (Index i = 0; i < y.size(); ++i)
        y[i] += coefficients[k] * (filled ? samples[row * y.size() + i] : u[i]);
      row = row + 1 < before ? row + 1 : 0;
    }
  }

  void update() {
    const Index before = coefficients.size() - 1, row = static_cast<Index>(oldest);
    const bool filled = begun > 0.0 && !resetting();
    const Index first = filled ? row : 0, end = filled ? row + 1 : before;
    for (Index k = first; k < end; ++k)
      for (Index i = 0; i < u.size(); ++i) samples[k * u.size() + i] = u[i];
    oldest = row + 1 < before ? static_cast<double>(row + 1) : 0.0;
    begun = 1.0;
    remember_reset();
  }

  void configure(Configure& is);
  static void declare(Declare<SavitzkyGolay>& is);
};

}  // namespace stepwire
