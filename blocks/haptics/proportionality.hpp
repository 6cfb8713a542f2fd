#pragma once

#include <algorithm>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Magnitude of the largest resistance over the signed distance Er from the resistance boundary, positive
/// outside.
struct Proportionality {
  enum class Law { P1, P2, piecewise };

  Law law = Law::P1;
  double offset = 0.0, slope = 0.0;
  double W = -1e-3, maximum = 0.0;
  Numbers points{}, values{};
  Input<> u{};
  Output<> y{};

  void outputs() {
    y.each([&](Index i) { return magnitude(u[i]); });
  }

  double magnitude(double error) const {
    if (law == Law::P1) return error >= 0.0 ? offset + slope * error : 0.0;
    if (law == Law::P2) return maximum * std::clamp(1.0 - error / W, 0.0, 1.0);
    return between_points(error);
  }

  void configure(Configure& is);

  static void declare(Declare<Proportionality>& is);

 private:
  /// Interpolates linearly between the points; of two points at one error, the later one applies from there
  /// on.
  double between_points(double error) const {
    const Index last = points.size() - 1;
    if (error < points[0]) return values[0];
    Index next = 1;
    while (next <= last && points[next] <= error) ++next;
    if (next > last) return values[last];
    const double share = (error - points[next - 1]) / (points[next] - points[next - 1]);
    return values[next - 1] + share * (values[next] - values[next - 1]);
  }
};

}  // namespace stepwire
