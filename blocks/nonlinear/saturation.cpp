#include "blocks/nonlinear/saturation.hpp"

#include "engine/model/block/declare.hpp"
#include "engine/model/block/limits.hpp"

namespace stepwire {

void Saturation::configure(Configure& is) {
  require_order<&Saturation::lower, &Saturation::upper>(*this, is);
}

void Saturation::declare(Declare<Saturation>& is) {
  is.block("Saturation", {.doc = "The input within limits: y = min(max(u, lower), upper).",
                          .symbol = {.curve = "M-1 -.7H-.5L.5 .7H1", .axes = true}});
  is.parameter<&Saturation::lower>({.unit = "'u", .doc = "lowest output; none where left out"});
  is.parameter<&Saturation::upper>({.unit = "'u", .doc = "highest output; none where left out"});
  is.input<&Saturation::u>({.unit = "'u", .doc = "signal to limit"});
  is.output<&Saturation::y>({.unit = "'u", .doc = "the signal within the limits"});
}

}  // namespace stepwire
