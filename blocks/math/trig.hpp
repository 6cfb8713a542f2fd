#pragma once

#include <cmath>

#include "engine/base/math/elementary.hpp"
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
        return fn::sin(x);
      case Function::cos:
        return fn::cos(x);
      case Function::tan:
        return fn::tan(x);
      case Function::asin:
        return fn::asin(x);
      case Function::acos:
        return fn::acos(x);
      case Function::atan:
        return fn::atan(x);
      case Function::sinh:
        return fn::sinh(x);
      case Function::cosh:
        return fn::cosh(x);
      case Function::tanh:
        break;
    }
    return fn::tanh(x);
  }

  static void declare(Declare<Trig>& is);
};

}  // namespace stepwire
