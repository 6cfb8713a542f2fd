#include "blocks/nonlinear/rate_limiter.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void RateLimiter::declare(Declare<RateLimiter>& is) {
  is.block(
      "RateLimiter",
      {.doc =
           "Follows its input no faster than its rates: y[k] is u[k], held between y[k-1] + falling T and "
           "y[k-1] + rising T, where T is the block's period. It starts at `initial`, whatever the input is. "
           "Between its ticks the output is held.",
       .symbol = {.curve = "M-1 -.8H-.5L.5 .8H1"}});
  is.parameter<&RateLimiter::rising>({.unit = "'u/s", .doc = "fastest rise", .at_least = 0.0});
  is.parameter<&RateLimiter::falling>(
      {.unit = "'u/s", .doc = "fastest fall, a negative number", .at_most = 0.0});
  is.input<&RateLimiter::u>({.unit = "'u", .doc = "signal to follow"});
  is.output<&RateLimiter::y>({.unit = "'u", .doc = "the signal with limited rate"});
  is.state<&RateLimiter::last>({.unit = "'u", .doc = "output at the last tick"});
  is.state<&RateLimiter::elapsed>(
      {.unit = "s", .doc = "time since the last tick, 0 at the first", .settable = false});
  is.clock<&RateLimiter::period>();
}

}  // namespace stepwire
