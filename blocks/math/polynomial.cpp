#include "blocks/math/polynomial.hpp"

#include <fmt/format.h>

#include "engine/base/text/count.hpp"
#include "engine/model/block/declare.hpp"

namespace stepwire {

void Polynomial::configure(Configure& is) {
  if (coefficients.size() == 0)
    is.refuse<&Polynomial::coefficients>("is empty; give at least one, the highest power first");
  if (hold.size() != 0 && hold.size() != 2)
    is.refuse<&Polynomial::hold>(
        fmt::format("has {}; it takes two, [lower, upper]", text::counted(hold.size(), "number")));
  if (hold.size() == 2 && !(hold[0] < hold[1]))
    is.refuse<&Polynomial::hold>(
        fmt::format("[{}, {}] is no range; the lower end comes first", hold[0], hold[1]));
}

void Polynomial::declare(Declare<Polynomial>& is) {
  is.block("Polynomial",
           {.doc = "A polynomial of each element: coefficients [a, b, c] give y = a u^2 + b u + c. "
                   "Everything is in SI; the coefficients carry the units that this asks for.",
            .symbol = {.text = "P(u)"},
            .smooth = true});
  is.parameter<&Polynomial::coefficients>({.unit = "*", .doc = "highest power first, as in MATLAB"});
  is.parameter<&Polynomial::hold>(
      {.unit = "'u",
       .doc = "[lower, upper]: beyond this range the argument is held at its end; left out: no limit"});
  is.input<&Polynomial::u>({.unit = "'u", .doc = "argument"});
  is.output<&Polynomial::y>({.unit = "*", .doc = "value of the polynomial"});
}

}  // namespace stepwire
