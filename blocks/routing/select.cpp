#include "blocks/routing/select.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Select::configure(Configure& is) {
  for (const double index : indices) {
    if (index != std::floor(index)) is.refuse<&Select::indices>(fmt::format("{} is no whole number", index));
  }
  is.size("m", indices.size());
  is.size_at_least("n", static_cast<Index>(*std::max_element(indices.begin(), indices.end())));
}

void Select::declare(Declare<Select>& is) {
  is.block(
      "Select",
      {.doc = "Chosen elements of a vector in a chosen order: y = [u[i], u[j], ...]. An element may come "
              "more than once.",
       .symbol = {.text = "u{indices|[i]}"},
       .smooth = true});
  is.parameter<&Select::indices>({.doc = "which elements, the first of u being 1, e.g. [3, 1]",
                                  .at_least = 1.0,
                                  .at_most = 1e6,
                                  .required = true,
                                  .structural = true});
  is.input<&Select::u>({.unit = "'u", .shape = "n", .doc = "vector"});
  is.output<&Select::y>({.unit = "'u", .shape = "m", .doc = "the chosen elements"});
}

}  // namespace stepwire
