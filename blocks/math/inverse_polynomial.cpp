#include "blocks/math/inverse_polynomial.hpp"

#include <fmt/format.h>

#include "engine/model/block/declare.hpp"

namespace stepwire {

namespace {

/// number of checked intervals, fine enough for polynomials of real devices
constexpr int steps = 1000;

void refuse_what_does_not_rise(const InversePolynomial& block, const Configure& is) {
  const double low = block.range[0], width = block.range[1] - block.range[0];
  for (int k = 0; k < steps; ++k) {
    const double x = low + width * k / steps, next = low + width * (k + 1) / steps;
    if (!(block.value(x) < block.value(next)))
      is.refuse<&InversePolynomial::range>(
          fmt::format("the polynomial does not rise at {}, so that a value may have several arguments; it "
                      "must rise over the whole range",
                      x));
  }
}

}  // namespace

void InversePolynomial::configure(Configure& is) {
  if (coefficients.size() == 0)
    is.refuse<&InversePolynomial::coefficients>("is empty; give at least two, the highest power first");
  if (range.size() != 2 || !(range[0] < range[1]))
    is.refuse<&InversePolynomial::range>("is not a lower and a higher argument, such as [0 A, 0.35 A]");
  refuse_what_does_not_rise(*this, is);
}

void InversePolynomial::declare(Declare<InversePolynomial>& is) {
  is.block("InversePolynomial",
           {.doc = "The argument at which a polynomial has a given value, e.g. the current that makes a "
                   "damper's force. The polynomial must rise over the range; a value below what it has "
                   "there gives the lower end, one above the upper end.",
            .symbol = {.text = "P⁻¹(u)"}});
  is.parameter<&InversePolynomial::coefficients>({.unit = "*",
                                                  .doc = "highest power first, as those of a Polynomial: "
                                                         "[a, b, c] is a y^2 + b y + c"});
  is.parameter<&InversePolynomial::range>({.unit = "'y", .doc = "[lower, upper] argument"});
  is.input<&InversePolynomial::u>({.unit = "*", .doc = "value of the polynomial"});
  is.output<&InversePolynomial::y>({.unit = "'y", .doc = "the argument"});
}

}  // namespace stepwire
