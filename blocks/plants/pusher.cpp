#include "blocks/plants/pusher.hpp"

#include <fmt/format.h>

#include <cmath>

#include "engine/base/math/sum_of_squares.hpp"
#include "engine/model/block/configure.hpp"
#include "engine/model/block/declare.hpp"

namespace stepwire {

namespace {

double length_of_leg(const Matrix& points, Index leg) {
  return length_of(points.columns(), [&](Index i) { return points(leg + 1, i) - points(leg, i); });
}

}  // namespace

void Pusher::configure(Configure& is) {
  if (points.rows() < 2)
    is.refuse<&Pusher::points>(fmt::format(
        "there is {} point; it takes two or more, as [[0 mm, 0 mm], [9 mm, 5 mm]]", points.rows()));
  for (Index k = 0; k + 1 < points.rows(); ++k)
    if (!(length_of_leg(points, k) > 0.0))
      is.refuse<&Pusher::points>(
          fmt::format("point {} lies where point {} does; leave one out", k + 2, k + 1));
}

void Pusher::prepare() {
  std::vector<double> numbers;
  double at = 0.0, behind = 0.0;
  for (Index k = 0; k + 1 < points.rows(); ++k) {
    const double length = length_of_leg(points, k);
    // A leg that is too short for the speed has no cruise phase.
    const double up = std::min(speed / highest_acceleration, std::sqrt(length / highest_acceleration));
    const double even = length / (highest_acceleration * up) - up;
    numbers.insert(numbers.end(), {at, behind, length, up, std::max(even, 0.0)});
    at += 2.0 * up + std::max(even, 0.0);
    behind += length;
  }
  legs = Numbers(numbers);
}

void Pusher::declare(Declare<Pusher>& is) {
  is.block("Pusher",
           {.doc = "A programmable motor on a sliding table: it moves through points, straight from each to "
                   "the next, whatever resists, speeding up and slowing down evenly, and stops at each. A "
                   "speed that is never reached makes a push of constant acceleration. Gives position, "
                   "velocity and acceleration for the pin of a DrivenLinkage.",
            .source = "thesis 3.5, figure 32"});
  is.parameter<&Pusher::points>({.unit = "m",
                                 .shape = "k x d",
                                 .doc = "a row for each point, in the order of the motion",
                                 .required = true});
  is.parameter<&Pusher::speed>({.unit = "m/s", .doc = "between the points", .above = 0.0});
  is.parameter<&Pusher::highest_acceleration>(
      {.unit = "m/s2", .doc = "up to that speed, and before each point down from it", .above = 0.0});
  is.parameter<&Pusher::begin>({.unit = "s", .doc = "instant until which it rests at the first point"});
  is.output<&Pusher::position>({.unit = "m", .shape = "d", .doc = "position"});
  is.output<&Pusher::velocity>({.unit = "m/s", .shape = "d", .doc = "its derivative"});
  is.output<&Pusher::acceleration>({.unit = "m/s2", .shape = "d", .doc = "derivative of the velocity"});
  is.output<&Pusher::distance>({.unit = "m", .doc = "way from the first point"});
  is.output<&Pusher::leg>({.doc = "number of the way from point to point that it is on, from 1"});
  is.clock<&Pusher::time>();
  is.derived<&Pusher::legs, &Pusher::points, &Pusher::speed, &Pusher::highest_acceleration>();
}

}  // namespace stepwire
