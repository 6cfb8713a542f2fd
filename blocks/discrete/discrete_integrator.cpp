#include "blocks/discrete/discrete_integrator.hpp"

#include "engine/model/block/declare_reset.hpp"
#include "engine/model/block/limits.hpp"

namespace stepwire {

void DiscreteIntegrator::declare(Declare<DiscreteIntegrator>& is) {
  is.block(
      "DiscreteIntegrator",
      {.doc =
           "Integral by sums at its ticks, with e = gain u: forward_euler y[k+1] = y[k] + T e[k] (the output "
           "does not depend on the input at the same tick); backward_euler y[k] = y[k-1] + T e[k]; "
           "trapezoidal "
           "y[k] = y[k-1] + T (e[k] + e[k-1]) / 2. The last two start from `initial` with e[-1] = 0. At a "
           "limit "
           "the sum stops.",
       .symbol = {.text = "T Σ u"}});
  is.parameter<&DiscreteIntegrator::gain>({.unit = "'k", .doc = "factor"});
  is.parameter<&DiscreteIntegrator::lower>({.unit = "'k 'u s", .doc = "lowest value; none where left out"});
  is.parameter<&DiscreteIntegrator::upper>({.unit = "'k 'u s", .doc = "highest value; none where left out"});
  is.parameter<&DiscreteIntegrator::method>(
      {.doc = "approximation of the integral", .words = {"forward_euler", "backward_euler", "trapezoidal"}});
  is.input<&DiscreteIntegrator::u>({.unit = "'u", .doc = "rate of change"});
  is.output<&DiscreteIntegrator::y>({.unit = "'k 'u s", .doc = "the sum, within the limits"});
  is.state<&DiscreteIntegrator::x>({.unit = "'k 'u s", .doc = "the sum so far"});
  declare_reset(is, "'k 'u s", "the sum");
  is.clock<&DiscreteIntegrator::period>();
  is.derived<&DiscreteIntegrator::before, From::no_number>();
  is.derived<&DiscreteIntegrator::after, From::no_number>();
}

void DiscreteIntegrator::configure(Configure& is) {
  require_order<&DiscreteIntegrator::lower, &DiscreteIntegrator::upper>(*this, is);
  configure_reset(*this, is);
  before = method == Method::forward_euler ? 0.0 : method == Method::backward_euler ? 1.0 : 0.5;
  after = 1.0 - before;
  is.feedthrough<&DiscreteIntegrator::u, &DiscreteIntegrator::y>(before > 0.0);
}

}  // namespace stepwire
