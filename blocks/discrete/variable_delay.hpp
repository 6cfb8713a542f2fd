#pragma once

#include <algorithm>

#include "engine/model/block/resettable.hpp"

namespace stepwire {

/// Delay by a time that may change: y(t) = u(t - delay), linear between the samples.
struct VariableDelay : Resettable {
  double longest = 0.0;
  PerElement initial = 0.0;
  Input<> u{};
  Input<1> delay{};
  Output<> y{};
  DiscreteState<> samples{};  // ring buffer with a row for each sample
  DiscreteState<1> newest{};  // last written row

  Index rows = 2;
  Period period{};

  void outputs() {
    if (resetting()) {
      y = Targets{*this};
      return;
    }
    const double back = std::clamp(delay / period, 1.0, static_cast<double>(rows - 1)) - 1.0;
    const auto whole = std::min(static_cast<Index>(back), rows - 2);
    const double part = back - static_cast<double>(whole);
    const Index later = row(whole), earlier = row(whole + 1);
    for (Index i = 0; i < y.size(); ++i)
      y[i] = samples[later + i] + part * (samples[earlier + i] - samples[later + i]);
  }

  void update() {
    if (resetting())
      for (Index k = 0; k < samples.size(); ++k) samples[k] = target(k % u.size());
    remember_reset();
    const Index next = static_cast<Index>(newest) + 1 < rows ? static_cast<Index>(newest) + 1 : 0;
    for (Index i = 0; i < u.size(); ++i) samples[next * u.size() + i] = u[i];
    newest = static_cast<double>(next);
  }

  void start() {
    for (Index i = 0; i < samples.size(); ++i) samples[i] = initial[i % initial.size()];
    for (Index i = 0; i < home.size(); ++i) home[i] = initial[i];
  }

  void configure(Configure& is);
  static void declare(Declare<VariableDelay>& is);

 private:
  /// Returns the begin of a row.
  Index row(Index before) const {
    const Index at = static_cast<Index>(newest) - before;
    return (at < 0 ? at + rows : at) * y.size();
  }
};

}  // namespace stepwire
