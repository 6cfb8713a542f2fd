#include "blocks/haptics/proportionality.hpp"

#include <fmt/core.h>

#include "engine/base/text/count.hpp"
#include "engine/model/block/declare.hpp"

namespace stepwire {

namespace {

void check_points(const Proportionality& block, const Configure& is) {
  const Numbers& points = block.points;
  if (points.size() == 0 || points.size() != block.values.size())
    is.refuse<&Proportionality::points>(
        fmt::format("{} and {}; 'law: piecewise' needs a value for each point",
                    text::there_are(points.size(), "point"), text::counted(block.values.size(), "value")));
  for (Index k = 0; k + 1 < points.size(); ++k)
    if (!(points[k] <= points[k + 1]))
      is.refuse<&Proportionality::points>(
          fmt::format("{} m follows on {} m; they must not fall", points[k + 1], points[k]));
}

}  // namespace

void Proportionality::configure(Configure& is) {
  if (law == Law::P2 && !(W < 0.0))
    is.refuse<&Proportionality::W>(fmt::format("{} m is not inside the boundary; it must be below 0", W));
  if (law == Law::piecewise) check_points(*this, is);
}

void Proportionality::declare(Declare<Proportionality>& is) {
  is.block(
      "Proportionality",
      {.doc = "Resistance proportionality: |F_max| over the signed distance Er from the resistance boundary, "
              "positive outside. P1 resists only outside: 0 for Er < 0, offset + slope Er from Er = 0 on. P2 "
              "also resists the approach: 0 up to Er = W, from there in a straight line to its maximum at Er "
              "= 0, "
              "which it keeps outside. piecewise is any other law: straight lines through `values` at "
              "`points`, the end values beyond them, and a jump where two points are the same.",
       .source = "thesis 3.4.1, figure 31"});
  is.parameter<&Proportionality::law>({.doc = "which law", .words = {"P1", "P2", "piecewise"}});
  is.parameter<&Proportionality::offset>(
      {.unit = "N", .doc = "P1: magnitude felt on entering, at Er = 0", .at_least = 0.0});
  is.parameter<&Proportionality::slope>(
      {.unit = "N/m", .doc = "P1: rise per distance outside", .at_least = 0.0});
  is.parameter<&Proportionality::W>(
      {.unit = "m", .doc = "P2: where the rise begins, inside the boundary (negative)"});
  is.parameter<&Proportionality::maximum>(
      {.unit = "N", .doc = "P2: magnitude on the boundary and beyond", .at_least = 0.0});
  is.parameter<&Proportionality::points>({.unit = "m", .doc = "piecewise: distances Er, in rising order"});
  is.parameter<&Proportionality::values>(
      {.unit = "N", .doc = "piecewise: the magnitude at each of them", .at_least = 0.0});
  is.input<&Proportionality::u>(
      {.unit = "m", .doc = "signed distance Er from the boundary, positive outside"});
  is.output<&Proportionality::y>({.unit = "N", .doc = "|F_max|, never negative"});
}

}  // namespace stepwire
