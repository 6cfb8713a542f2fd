#include "blocks/math/slice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Slice::configure(Configure& is) {
  for (const double row : rows)
    if (row != std::floor(row)) is.refuse<&Slice::rows>(fmt::format("{} is no whole number", row));
  for (const double column : columns)
    if (column != std::floor(column))
      is.refuse<&Slice::columns>(fmt::format("{} is no whole number", column));
  is.size("p", rows.size());
  is.size("q", columns.size());
  is.size_at_least("m", static_cast<Index>(*std::max_element(rows.begin(), rows.end())));
  is.size_at_least("n", static_cast<Index>(*std::max_element(columns.begin(), columns.end())));
}

void Slice::declare(Declare<Slice>& is) {
  is.block("Slice", {.doc = "Chosen rows and columns of a matrix, in a chosen order. One element needs no "
                            "block: R.2.3 names it.",
                     .symbol = {.text = "u{rows|}"},
                     .smooth = true});
  is.parameter<&Slice::rows>({.doc = "rows, the first being 1, e.g. [3, 1]",
                              .at_least = 1.0,
                              .at_most = 1e6,
                              .required = true,
                              .structural = true});
  is.parameter<&Slice::columns>({.doc = "columns, the first being 1",
                                 .at_least = 1.0,
                                 .at_most = 1e6,
                                 .required = true,
                                 .structural = true});
  is.input<&Slice::u>({.unit = "'u", .shape = "m x n", .doc = "matrix"});
  is.output<&Slice::y>({.unit = "'u", .shape = "p x q", .doc = "the chosen rows and columns"});
  is.size<&Slice::height>("m");
}

}  // namespace stepwire
