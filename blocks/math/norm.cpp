#include "blocks/math/norm.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Norm::declare(Declare<Norm>& is) {
  is.block("Norm", {.doc = "The length of a vector, one number.", .symbol = {.text = "‖u‖"}, .smooth = true});
  is.parameter<&Norm::kind>({.doc = "euclidean: sqrt(sum u_k^2); sum: sum |u_k|; max: max |u_k|",
                             .words = {"euclidean", "sum", "max"}});
  is.input<&Norm::u>({.unit = "'u", .doc = "vector", .one_unit = true});
  is.output<&Norm::y>({.unit = "'u", .doc = "its length"});
}

}  // namespace stepwire
