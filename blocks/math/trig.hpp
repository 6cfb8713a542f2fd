#pragma once

#include <cmath>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// A trigonometric or hyperbolic function of each element: y = function(u), angles in radians.
struct Trig {
  enum class Function { sin, cos, tan, asin, acos, atan, sinh, cosh, tanh };

  Function function = Function::sin;
  Input<> u{};
  Output<> y{};

  void outputs() {
    y.each([&](Index k) { return of(u[k]); });
  }

  double of(double x) const {
    switch (function) {
      case Function::sin:
        return std::sin(x);
      case Function::cos:
        return std::cos(x);
      case Function::tan:
        return std::tan(x);
      case Function::asin:
        return std::asin(x);
      case Function::acos:
        return std::acos(x);
      case Function::atan:
        return std::atan(x);
      case Function::sinh:
        return std::sinh(x);
      case Function::cosh:
        return std::cosh(x);
      case Function::tanh:
        break;
    }
    return std::tanh(x);
  }

  static void declare(Declare<Trig>& is);
};

}  // namespace stepwire
