#pragma once

#include <cmath>

#include "engine/base/math/elementary.hpp"
#include "engine/base/math/sum_of_squares.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Drift of a sense by movement: with the path length s of the position,
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
    const double share = begun != 0.0 ? -fn::expm1(-gone() / path) : 0.0;
    drift.each([&](Index i) { return drift[i] + share * (place[i] - drift[i]); });
    last = position;
    begun = 1.0;
  }

  void configure(Configure& is);
  static void declare(Declare<PathDrift>& is);

 private:
  double gone() const {
    return length_of(position.size(), [&](Index i) { return position[i] - last[i]; });
  }
};

}  // namespace stepwire
