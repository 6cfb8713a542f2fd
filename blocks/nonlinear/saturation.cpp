#include "blocks/nonlinear/saturation.hpp"

#include "engine/model/block/declare.hpp"
#include "engine/model/block/limits.hpp"

namespace stepwire {

void Saturation::configure(Configure& is) {
  const bool wired = is.connected<&Saturation::lower_>() || is.connected<&Saturation::upper_>();
  if (!wired) require_order<&Saturation::lower, &Saturation::upper>(*this, is);
}

void Saturation::declare(Declare<Saturation>& is) {
  is.block("Saturation",
           {.doc = "The input within limits: y = min(max(u, lower), upper). A limit is a number or a "
                   "signal; where signals cross, the upper limit holds.",
            .symbol = {.curve = "M-1 -.7H-.5L.5 .7H1", .axes = true},
            .smooth = true});
  is.parameter<&Saturation::lower>({.unit = "'u", .doc = "lowest output; none where left out"});
  is.parameter<&Saturation::upper>({.unit = "'u", .doc = "highest output; none where left out"});
  is.input<&Saturation::u>({.unit = "'u", .doc = "signal to limit"});
  is.input<&Saturation::lower_>({.unit = "'u", .doc = "lowest output as a signal", .optional = true});
  is.input<&Saturation::upper_>({.unit = "'u", .doc = "highest output as a signal", .optional = true});
  is.crossing<&Saturation::u, &Saturation::lower_>("u reaches the lower limit");
  is.crossing<&Saturation::u, &Saturation::upper_>("u reaches the upper limit");
  is.output<&Saturation::y>({.unit = "'u", .doc = "the signal within the limits"});
}

}  // namespace stepwire
