#pragma once

#include "engine/model/block/resettable.hpp"

namespace stepwire {

/// Delay by a time of whole periods: y(t) = u(t - delay).
struct Delay : Resettable {
  double delay = 0.0;
  PerElement initial = 0.0;
  Input<> u{};
  Output<> y{};
  DiscreteState<> samples{};  // ring buffer with a row for each sample
  DiscreteState<1> oldest{};  // row that is the next output and is then overwritten

  Index periods = 1;

  void outputs() {
    if (resetting()) {
      y = Targets{*this};
      return;
    }
    const Index first = static_cast<Index>(oldest) * y.size();
    for (Index i = 0; i < y.size(); ++i) y[i] = samples[first + i];
  }

  void update() {
    if (resetting())
      for (Index k = 0; k < samples.size(); ++k) samples[k] = target(k % u.size());
    remember_reset();
    const Index row = static_cast<Index>(oldest);
    for (Index i = 0; i < u.size(); ++i) samples[row * u.size() + i] = u[i];
    oldest = row + 1 < periods ? static_cast<double>(row + 1) : 0.0;
  }

  void start() {
    for (Index i = 0; i < samples.size(); ++i) samples[i] = initial[i % initial.size()];
    for (Index i = 0; i < home.size(); ++i) home[i] = initial[i];
  }

  void configure(Configure& is);
  static void declare(Declare<Delay>& is);
};

}  // namespace stepwire
