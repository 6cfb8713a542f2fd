#pragma once

#include "engine/block/declare.hpp"

namespace stepwire {

/// 1 for one tick where its input becomes true, false, or either. True is above 0.
struct EdgeDetect {
  enum class Edge { rising, falling, either };

  Edge edge = Edge::rising;
  Input<> u{};
  Output<> y{};
  DiscreteState<> side{};  // -1 false, 1 true, 0 none seen yet

  void outputs() {
    for (Eigen::Index i = 0; i < y.size(); ++i) y.coeffRef(i) = detected(i) ? 1.0 : 0.0;
  }

  void update() {
    for (Eigen::Index i = 0; i < side.size(); ++i) side.coeffRef(i) = u.coeff(i) > 0.0 ? 1.0 : -1.0;
  }

  static void declare(Declare<EdgeDetect>& is);

 private:
  bool detected(Eigen::Index i) const {
    const bool high = u.coeff(i) > 0.0;
    const bool rose = side.coeff(i) < 0.0 && high, fell = side.coeff(i) > 0.0 && !high;
    return (rose && edge != Edge::falling) || (fell && edge != Edge::rising);
  }
};

}  // namespace stepwire
