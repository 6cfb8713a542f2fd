#include "blocks/haptics/proportionality.hpp"

#include <fmt/core.h>

#include "engine/block/declare.hpp"

namespace stepwire {

void Proportionality::configure(Configure& is) {
  if (law == Law::P2 && !(W < 0.0))
    is.refuse<&Proportionality::W>(fmt::format("{} m is not inside the boundary; it must be below 0", W));
}

void Proportionality::declare(Declare<Proportionality>& is) {
  is.block(
      "Proportionality",
      {.doc = "Resistance proportionality: |F_max| over the signed distance Er from the resistance boundary, "
              "positive outside. P1 resists only outside: 0 for Er < 0, offset + slope Er from Er = 0 on. P2 "
              "also resists the approach: 0 up to Er = W, from there in a straight line to its maximum at Er "
              "= 0, "
              "which it keeps outside.",
       .source = "thesis 3.4.1, figure 31",
       .symbol = {.text = "{law}"}});
  is.parameter<&Proportionality::law>({.doc = "which of the two laws", .words = {"P1", "P2"}});
  is.parameter<&Proportionality::offset>(
      {.unit = "N", .doc = "P1: magnitude felt on entering, at Er = 0", .at_least = 0.0});
  is.parameter<&Proportionality::slope>(
      {.unit = "N/m", .doc = "P1: rise per distance outside", .at_least = 0.0});
  is.parameter<&Proportionality::W>(
      {.unit = "m", .doc = "P2: where the rise begins, inside the boundary (negative)"});
  is.parameter<&Proportionality::maximum>(
      {.unit = "N", .doc = "P2: magnitude on the boundary and beyond", .at_least = 0.0});
  is.input<&Proportionality::u>(
      {.unit = "m", .doc = "signed distance Er from the boundary, positive outside"});
  is.output<&Proportionality::y>({.unit = "N", .doc = "|F_max|, never negative"});
}

}  // namespace stepwire
