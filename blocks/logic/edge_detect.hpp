#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Output 1 for one tick when its input becomes true, false, or either. True is above 0.
struct EdgeDetect {
  enum class Edge { rising, falling, either };

  Edge edge = Edge::rising;
  Input<> u{};
  Output<> y{};
  DiscreteState<> side{};   // -1 false, 1 true, 0 unknown
  DiscreteState<> found{};  // 1 from an edge between two ticks through the next tick

  void outputs() {
    for (Index i = 0; i < y.size(); ++i) y[i] = found[i] > 0.0 || detected(i) ? 1.0 : 0.0;
  }

  void update() {
    remember();
    found = 0.0;
  }
  void update_at_event() {
    for (Index i = 0; i < found.size(); ++i)
      if (detected(i)) found[i] = 1.0;
    remember();
  }

  void crossings(Crossings& zero) const {
    for (Index i = 0; i < u.size(); ++i) zero.add(u[i]);
  }

  static void declare(Declare<EdgeDetect>& is);

 private:
  void remember() {
    for (Index i = 0; i < side.size(); ++i) side[i] = u[i] > 0.0 ? 1.0 : -1.0;
  }
  bool detected(Index i) const {
    const bool high = u[i] > 0.0;
    const bool rose = side[i] < 0.0 && high, fell = side[i] > 0.0 && !high;
    return (rose && edge != Edge::falling) || (fell && edge != Edge::rising);
  }
};

}  // namespace stepwire
