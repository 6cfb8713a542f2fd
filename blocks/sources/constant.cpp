#include "blocks/sources/constant.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Constant::declare(Declare<Constant>& is) {
  is.block("Constant",
           {.doc = "A value that does not change: y = value. It is computed once, before the run.",
            .symbol = {.text = "{value|c}"}});
  is.parameter<&Constant::value>(
      {.unit = "'u", .doc = "the value; a list gives a vector of as many elements"});
  is.output<&Constant::y>({.unit = "'u", .doc = "the value"});
}

}  // namespace stepwire
