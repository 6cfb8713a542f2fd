#include "blocks/math/sum.hpp"

#include <fmt/format.h>

#include "engine/base/text/count.hpp"
#include "engine/model/block/declare.hpp"

namespace stepwire {

void Sum::configure(Configure& is) {
  const std::string_view each = signs;
  if (each.find_first_not_of("+-") != std::string::npos)
    is.refuse<&Sum::signs>(fmt::format("'{}' is not made of + and -; one for each input, e.g. \"+-\"", each));
  const Index inputs = is.count<&Sum::u>();
  if (inputs > 64)
    is.refuse<&Sum::signs>(
        fmt::format("{} inputs are more than 64; add some of them in a Sum of their own", inputs));
  if (!each.empty() && static_cast<Index>(each.size()) != inputs)
    is.refuse<&Sum::signs>(fmt::format("'{}' has {} for {}; give one for each", each,
                                       text::counted(each.size(), "sign"), text::counted(inputs, "input")));
  negative = 0;
  for (std::size_t i = 0; i < each.size(); ++i) negative |= std::uint64_t{each[i] == '-'} << i;
}

void Sum::declare(Declare<Sum>& is) {
  is.block(
      "Sum",
      {.doc = "Adds and subtracts signals element by element. An input of one element counts for every "
              "element of the others. One input alone is passed on, or negated by the sign -; the elements "
              "of a vector are added by MatrixGain with [[1, 1, 1]].",
       .symbol = {.outline = Symbol::Outline::circle, .signs = "signs"},
       .smooth = true});
  is.parameter<&Sum::signs>({.doc = "a + or - for each input, quoted: \"+-\"; left out: all are added"});
  is.input<&Sum::u>({.unit = "'u", .doc = "signals, all of one unit"});
  is.output<&Sum::y>({.unit = "'u", .doc = "the sum"});
  is.derived<&Sum::negative>();
}

}  // namespace stepwire
