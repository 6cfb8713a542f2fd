#include "blocks/math/rotate.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Rotate::declare(Declare<Rotate>& is) {
  is.block("Rotate",
           {.doc = "A vector of the plane turned to the left by an angle: a radial and a tangential part at "
                   "the polar angle become x and y. With `inverse` it is turned to the right: x and y become "
                   "a radial and a tangential part.",
            .symbol = {.text = "R(angle) u"},
            .smooth = true});
  is.parameter<&Rotate::inverse>({.doc = "turn the other way"});
  is.input<&Rotate::u>({.unit = "'u", .shape = "2", .doc = "vector, [radial, tangential] or [x, y]"});
  is.input<&Rotate::angle>({.unit = "rad", .doc = "by which it is turned, from the x axis to the left"});
  is.output<&Rotate::y>({.unit = "'u", .shape = "2", .doc = "the turned vector"});
}

}  // namespace stepwire
