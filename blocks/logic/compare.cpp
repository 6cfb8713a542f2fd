#include "blocks/logic/compare.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Compare::declare(Declare<Compare>& is) {
  is.block(
      "Compare",
      {.doc = "1 where u stands in the given relation to `to`, 0 where not. `to` is a signal or a number: "
              "{block: Compare, u: x, operator: less, to: 5 mm}. Signs are quoted: \"<=\". Numbers are equal "
              "only "
              "if they are the same to the last bit.",
       .symbol = {.text = "{operator}"},
       .steady = true});
  is.parameter<&Compare::operator_>({.doc = "relation, as a word or a sign",
                                     .words = {"less", "less_equal", "greater", "greater_equal", "equal",
                                               "not_equal", "<", "<=", ">", ">=", "==", "!="},
                                     .required = true});
  is.input<&Compare::u>({.unit = "'u", .doc = "left of the sign"});
  is.input<&Compare::to>({.unit = "'u", .doc = "right of the sign"});
  is.crossing<&Compare::u, &Compare::to>("u passes `to`");
  is.output<&Compare::y>({.doc = "1 or 0"});
  is.derived<&Compare::relation>();
}

}  // namespace stepwire
