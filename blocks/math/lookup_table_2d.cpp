#include "blocks/math/lookup_table_2d.hpp"

#include "engine/base/text/count.hpp"
#include "engine/model/block/declare.hpp"

#include "blocks/math/table_check.hpp"

namespace stepwire {

void LookupTable2D::configure(Configure& is) {
  require_increasing<&LookupTable2D::rows>(is, rows);
  require_increasing<&LookupTable2D::columns>(is, columns);
  if (values.rows() != rows.size() || values.columns() != columns.size())
    is.refuse<&LookupTable2D::values>(
        fmt::format("is {} x {} for {} and {}; it must be {} x {}", values.rows(), values.columns(),
                    text::counted(rows.size(), "row"), text::counted(columns.size(), "column"), rows.size(),
                    columns.size()));
}

void LookupTable2D::declare(Declare<LookupTable2D>& is) {
  is.block("LookupTable2D",
           {.doc = "A surface given on a grid, bilinear between its points, of each element: "
                   "y = f(row, column).",
            .symbol = {.curve = "M-1 -.8H1V.8H-1ZM-1 .3H1M-1 -.25H1M-.35 -.8V.8M.35 -.8V.8"}});
  is.parameter<&LookupTable2D::rows>({.unit = "'r", .doc = "argument of each row, increasing, two or more"});
  is.parameter<&LookupTable2D::columns>(
      {.unit = "'c", .doc = "argument of each column, increasing, two or more"});
  is.parameter<&LookupTable2D::values>(
      {.unit = "'v", .doc = "list of rows, each with a value for each column"});
  is.parameter<&LookupTable2D::extrapolation>(
      {.doc = "beyond the grid: hold its edge, go on with the last straight line, or refuse (ends the run)",
       .words = {"hold", "linear", "refuse"}});
  is.input<&LookupTable2D::row>({.unit = "'r", .doc = "argument along the rows' points"});
  is.input<&LookupTable2D::column>({.unit = "'c", .doc = "argument along the columns' points"});
  is.output<&LookupTable2D::y>({.unit = "'v", .doc = "value of the surface"});
}

}  // namespace stepwire
