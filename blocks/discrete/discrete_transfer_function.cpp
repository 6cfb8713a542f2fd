#include "blocks/discrete/discrete_transfer_function.hpp"

#include "engine/model/block/declare_reset.hpp"

namespace stepwire {

void DiscreteTransferFunction::declare(Declare<DiscreteTransferFunction>& is) {
  using Block = DiscreteTransferFunction;
  is.block(
      "DiscreteTransferFunction",
      {.doc =
           "Y(z) / U(z) = numerator / denominator for one signal. Coefficients stand highest power of z "
           "first: "
           "[1, -0.9] is z - 0.9. The numerator's degree may not exceed the denominator's. The default is a "
           "delay by one period. "
           "The coefficients of the numerator share one unit, [0.1 m/N, 0.05 m/N]; those of the denominator "
           "are pure numbers.",
       .source = "controllable canonical form, e.g. Ogata, Discrete-Time Control Systems, section 5-2",
       .symbol = {.text = "{numerator:z|num(z)} / {denominator:z|den(z)}"}});
  is.parameter<&Block::numerator>({.unit = "'n", .doc = "coefficients, highest power of z first"});
  is.parameter<&Block::denominator>({.unit = "1", .doc = "coefficients, highest power of z first"});
  is.input<&Block::u>({.unit = "'u", .doc = "input; felt at once only where both degrees are equal"});
  is.output<&Block::y>({.unit = "'n 'u", .doc = "output"});
  is.state<&Block::x>({.unit = "*", .shape = "n", .doc = "states of the canonical form, newest first"});
  declare_reset(is, "*", "the states", "n");
  is.derived<&DiscreteTransferFunction::form, &DiscreteTransferFunction::numerator,
             &DiscreteTransferFunction::denominator>();
}

void DiscreteTransferFunction::configure(Configure& is) {
  using Block = DiscreteTransferFunction;
  const std::string problem = Rational::problem_of(numerator, denominator);
  if (!problem.empty()) is.refuse<&Block::denominator>(problem);
  form = Rational::of(numerator, denominator);
  configure_reset(*this, is);
  is.size("n", form.order());
  is.feedthrough<&Block::u, &Block::y>(form.direct != 0.0);
}

}  // namespace stepwire
