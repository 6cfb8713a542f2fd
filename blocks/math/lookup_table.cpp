#include "blocks/math/lookup_table.hpp"

#include "engine/base/text/count.hpp"
#include "engine/model/block/declare.hpp"

#include "blocks/math/table_check.hpp"

namespace stepwire {

void LookupTable::configure(Configure& is) {
  require_increasing<&LookupTable::points>(is, points);
  if (values.size() != points.size())
    is.refuse<&LookupTable::values>(fmt::format("has {} for {}; give one for each",
                                                text::counted(values.size(), "element"),
                                                text::counted(points.size(), "point")));
}

void LookupTable::declare(Declare<LookupTable>& is) {
  is.block("LookupTable",
           {.doc = "A curve given by points, with straight lines between them, of each element: y = f(u). "
                   "For a table of two arguments see LookupTable2D.",
            .symbol = {.curve = "M-1 -.9L-.5 -.6L0 .2L.4 .7L1 .9", .axes = true}});
  is.parameter<&LookupTable::points>({.unit = "'u", .doc = "arguments, increasing, two or more"});
  is.parameter<&LookupTable::values>({.unit = "'v", .doc = "the curve at each of them"});
  is.parameter<&LookupTable::extrapolation>(
      {.doc = "beyond the points: hold the end, go on with the last straight line, or refuse (ends the run)",
       .words = {"hold", "linear", "refuse"}});
  is.input<&LookupTable::u>({.unit = "'u", .doc = "argument"});
  is.output<&LookupTable::y>({.unit = "'v", .doc = "value of the curve"});
}

}  // namespace stepwire
