#pragma once

#include <cmath>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Drift of a sense by movement: with the path s that the position has gone,
///
///     d(drift)/ds = (place - drift)/path,   exactly from tick to tick.
struct PathDrift {
  Input<> position{};
  PerElement place = 0.0;
  double path = 1.0;
  Output<> y{};
  DiscreteState<> drift{}, last{};
  DiscreteState<1> begun{};

  void outputs() { y = drift; }

  void update() {
    const double share = begun != 0.0 ? -std::expm1(-gone() / path) : 0.0;
    drift.each([&](Index i) { return drift[i] + share * (place[i] - drift[i]); });
    last = position;
    begun = 1.0;
  }

  void configure(Configure& is);
  static void declare(Declare<PathDrift>& is);

 private:
  double gone() const {
    double square = 0.0;
    for (Index i = 0; i < position.size(); ++i) square += (position[i] - last[i]) * (position[i] - last[i]);
    return std::sqrt(square);
  }
};

}  // namespace stepwire
