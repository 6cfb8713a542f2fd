#include "blocks/routing/demux.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <string>

#include "engine/base/text/count.hpp"
#include "engine/model/block/declare.hpp"

namespace stepwire {

namespace {

constexpr Index max_pieces = 8;

}  // namespace

void Demux::configure(Configure& is) {
  if (sizes.size() == 0 || sizes.size() > max_pieces)
    is.refuse<&Demux::sizes>(
        fmt::format("names {}; from 1 to {} are possible", text::counted(sizes.size(), "piece"), max_pieces));
  for (const double size : sizes)
    if (size != std::floor(size))
      is.refuse<&Demux::sizes>(fmt::format("{} is no whole number of elements", size));
  for (Index piece = 0; piece < max_pieces; ++piece)
    is.size(std::string(1, static_cast<char>('a' + piece)),
            piece < sizes.size() ? static_cast<Index>(sizes[piece]) : 0);
  is.size("n", static_cast<Index>(std::accumulate(sizes.begin(), sizes.end(), 0.0)));
}

void Demux::declare(Declare<Demux>& is) {
  is.block(
      "Demux",
      {.doc = "Takes a vector apart: y1 has the first sizes[1] elements of u, y2 the next sizes[2], up to "
              "y8. Outputs beyond the list are empty. Single elements in any order: Select.",
       .symbol = {.outline = Symbol::Outline::bar},
       .smooth = true});
  is.parameter<&Demux::sizes>({.doc = "elements of each piece, e.g. [1, 1, 2]; together as many as u has",
                               .at_least = 1.0,
                               .at_most = 1e6,
                               .required = true,
                               .structural = true});
  is.input<&Demux::u>({.unit = "'u", .shape = "n", .doc = "vector"});
  is.output<&Demux::y1>({.unit = "'u", .shape = "a", .doc = "first piece"});
  is.output<&Demux::y2>({.unit = "'u", .shape = "b", .doc = "second piece"});
  is.output<&Demux::y3>({.unit = "'u", .shape = "c", .doc = "third piece"});
  is.output<&Demux::y4>({.unit = "'u", .shape = "d", .doc = "fourth piece"});
  is.output<&Demux::y5>({.unit = "'u", .shape = "e", .doc = "fifth piece"});
  is.output<&Demux::y6>({.unit = "'u", .shape = "f", .doc = "sixth piece"});
  is.output<&Demux::y7>({.unit = "'u", .shape = "g", .doc = "seventh piece"});
  is.output<&Demux::y8>({.unit = "'u", .shape = "h", .doc = "eighth piece"});
}

}  // namespace stepwire
