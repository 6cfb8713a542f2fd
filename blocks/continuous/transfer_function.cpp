#include "blocks/continuous/transfer_function.hpp"

#include "engine/model/block/declare_reset.hpp"

namespace stepwire {

void TransferFunction::declare(Declare<TransferFunction>& is) {
  is.block("TransferFunction",
           {.doc = "Y(s) / U(s) = numerator / denominator for one signal. Coefficients stand highest power "
                   "of s first: "
                   "[1, 0.2, 4] is s^2 + 0.2 s + 4. The numerator's degree may not exceed the denominator's. "
                   "Each coefficient may carry its unit, which falls by one s from power to power: "
                   "[2 kg, 8 N s/m, 200 N/m].",
            .source = "controllable canonical form, e.g. Ogata, Modern Control Engineering, section 9-2",
            .discrete = "DiscreteTransferFunction",
            .symbol = {.text = "{numerator:s|num(s)} / {denominator:s|den(s)}"},
            .smooth = true});
  is.parameter<&TransferFunction::numerator>(
      {.unit = "'n by s", .doc = "coefficients, highest power of s first"});
  is.parameter<&TransferFunction::denominator>(
      {.unit = "'d by s", .doc = "coefficients, highest power of s first"});
  is.input<&TransferFunction::u>(
      {.unit = "'u", .doc = "input; felt at once only where both degrees are equal"});
  is.output<&TransferFunction::y>({.unit = "'n 'u/'d", .doc = "output"});
  is.state<&TransferFunction::x>(
      {.unit = "*", .shape = "n", .doc = "states of the canonical form, highest derivative first"});
  declare_reset(is, "*", "the states", "n");
  is.derived<&TransferFunction::form, &TransferFunction::numerator, &TransferFunction::denominator>();
}

void TransferFunction::configure(Configure& is) {
  const std::string problem = Rational::problem_of(numerator, denominator);
  if (!problem.empty()) is.refuse<&TransferFunction::denominator>(problem);
  form = Rational::of(numerator, denominator);
  if (!configure_reset(*this, is)) is.skip_update();
  is.size("n", form.order());
  is.feedthrough<&TransferFunction::u, &TransferFunction::y>(form.direct != 0.0);
}

}  // namespace stepwire
