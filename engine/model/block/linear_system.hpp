#pragma once

#include "engine/model/block/dense.hpp"
#include "engine/model/block/resettable.hpp"

namespace stepwire {

/// Linear system of a block: dx/dt or x[k+1] = A x + B u, y = C x + D u. Its numbers have no units.
struct LinearSystem : Resettable {
  Matrix A, B, C, D;
  Input<> u{};
  bool direct = false;  // true if u is connected and D is not zero
};

/// Linear system with an observer of constant gain L.
struct LinearObserver : LinearSystem {
  Matrix L;
  Input<> measured{};
  Output<> estimate{};
};

}  // namespace stepwire
