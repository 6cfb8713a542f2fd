#include "blocks/math/lookup_table_nd.hpp"

#include <fmt/format.h>

#include <vector>

#include "engine/base/expression/expression.hpp"
#include "engine/model/block/declare.hpp"

namespace stepwire {

namespace {

using Block = LookupTableND;

/// Reads nested lists of numbers: `5 mm`, `2*pi`.
template <auto parameter>
class NestedReader {
 public:
  explicit NestedReader(const Configure& is) : is_(is) {}

  std::vector<double> row(const Value& tree) const {
    std::vector<double> numbers;
    if (!tree.list() || tree.list()->empty()) is_.refuse<parameter>("must be a list of numbers here", tree);
    for (const Value& element : *tree.list()) numbers.push_back(number(element));
    return numbers;
  }

  /// Collects all numbers of nested lists, which must have the depth and lengths of `sizes`.
  void gather(const Value& tree, const std::vector<double>& sizes, std::size_t depth,
              std::vector<double>& all) const {
    const auto size = static_cast<std::size_t>(sizes[depth]);
    if (!tree.list() || tree.list()->size() != size)
      is_.refuse<parameter>(
          fmt::format("must have a list of {} here, one for each point of dimension {}", size, depth + 1),
          tree);
    for (const Value& element : *tree.list())
      if (depth + 1 == sizes.size()) {
        all.push_back(number(element));
      } else {
        gather(element, sizes, depth + 1, all);
      }
  }

 private:
  double number(const Value& tree) const {
    double number = std::numeric_limits<double>::quiet_NaN();
    try {
      if (tree.text())
        number = expression::Expression(*tree.text(), [](std::string_view) { return false; })({});
    } catch (const expression::ExpressionError&) {
    }
    if (!std::isfinite(number))
      is_.refuse<parameter>(fmt::format("'{}' is no finite number", tree.text() ? *tree.text() : "this"),
                            tree);
    return number;
  }

  const Configure& is_;
};

void require_increasing(const Configure& is, const std::vector<double>& points, const Value& where) {
  if (points.size() < 2) is.refuse<&Block::points>("a dimension needs two points or more", where);
  for (std::size_t i = 1; i < points.size(); ++i)
    if (!(points[i] > points[i - 1]))
      is.refuse<&Block::points>(
          fmt::format("points must increase; {} does not lie above {}", points[i], points[i - 1]), where);
}

}  // namespace

void LookupTableND::configure(Configure& is) {
  const Value lists = points.value(), nested = values.value();
  const auto dimensions = static_cast<std::size_t>(is.count<&Block::u>());
  if (!lists.list() || lists.list()->size() != dimensions)
    is.refuse<&Block::points>(fmt::format("must be {} lists of points, one for each input", dimensions),
                              lists);
  if (dimensions > max_dimensions)
    is.refuse<&Block::points>(
        fmt::format("has {} dimensions; at most {} are possible", dimensions, max_dimensions));
  std::vector<double> all, sizes, table_values;
  for (const Value& list : *lists.list()) {
    const std::vector<double> row = NestedReader<&Block::points>(is).row(list);
    require_increasing(is, row, list);
    all.insert(all.end(), row.begin(), row.end());
    sizes.push_back(static_cast<double>(row.size()));
  }
  NestedReader<&Block::values>(is).gather(nested, sizes, 0, table_values);
  grid = Numbers(all);
  count = Numbers(sizes);
  table = Numbers(table_values);
}

void LookupTableND::declare(Declare<LookupTableND>& is) {
  is.block(
      "LookupTableND",
      {.doc = "A table over a grid of one to eight dimensions, linear between its points along each, of each "
              "element. `values` are lists in lists: the outermost has an element for each point of the "
              "first input. {u: [speed, load, heat], points: [[0, 1], [0, 5], [20, 80]], values: [[[1, 2], "
              "[3, 4]], [[5, 6], [7, 8]]]}. Points and values may have units (5 mm) and are SI; what is "
              "wired is not checked against them.",
       .symbol = {.curve = "M-1 -.8H.5V.4H-1ZM-1 .4L-.5 .8H1V-.4L.5 -.8M.5 .4L1 .8M-1 -.2H.5M-.3 -.8V.4"}});
  is.parameter<&Block::points>(
      {.doc = "for each input the list of its points, increasing, two or more", .required = true});
  is.parameter<&Block::values>({.doc = "values on the grid, lists in lists", .required = true});
  is.parameter<&Block::extrapolation>(
      {.doc = "beyond the grid: hold its edge, go on with the last straight line, or refuse (ends the run)",
       .words = {"hold", "linear", "refuse"}});
  is.input<&Block::u>({.unit = "*", .doc = "an argument for each dimension"});
  is.output<&Block::y>({.unit = "*", .doc = "value of the table"});
  is.derived<&Block::grid>();
  is.derived<&Block::count>();
  is.derived<&Block::table>();
}

}  // namespace stepwire
