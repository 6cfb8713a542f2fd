#include "blocks/math/gain.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Gain::declare(Declare<Gain>& is) {
  is.block("Gain", {.doc = "Each element times a number: y = gain u. For a matrix see MatrixGain.",
                    .symbol = {.text = "{gain|K}", .outline = Symbol::Outline::triangle},
                    .smooth = true});
  is.parameter<&Gain::gain>({.unit = "'k", .doc = "one factor for all elements, or one for each"});
  is.input<&Gain::u>({.unit = "'u", .doc = "signal"});
  is.output<&Gain::y>({.unit = "'k 'u", .doc = "gain times u"});
}

}  // namespace stepwire
