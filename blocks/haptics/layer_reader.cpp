#include "blocks/haptics/layer_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "blocks/haptics/layer_activator.hpp"
#include "blocks/haptics/region/shape_reader.hpp"

namespace stepwire {

namespace {

const std::string switch_example = "{from: 1, to: 2, when: {pass: [0 mm, 220 mm], within: 3 mm}}";
const std::string event_examples =
    "{pass: [0 mm, 220 mm], within: 3 mm}, {cross: [[0 mm, 200 mm], [0 mm, 240 mm]], toward: left}, "
    "{enter: 1}, {leave: 1} (of the regions) or {after: 2 s}";

}  // namespace

LayerSwitches LayerReader::read(const Value& tree) const {
  LayerSwitches all;
  if (!tree.list() || tree.list()->empty())
    refuse_("it must be a list of switches, as " + switch_example, tree);
  for (const Value& item : *tree.list()) read_switch(item, all);
  return all;
}

void LayerReader::read_switch(const Value& tree, LayerSwitches& all) const {
  if (!tree.map()) refuse_("a switch is a map, as " + switch_example, tree);
  allow(tree, {"from", "to", "when"});
  const double from = read_index(tree.find("from"), tree, "from", layers_);
  const double to = read_index(tree.find("to"), tree, "to", layers_);
  if (from == to) refuse_("a switch leads from a layer to another one", tree);
  const Value* when = tree.find("when");
  if (!when) refuse_("'when' is missing, as in " + switch_example, tree);
  const std::vector<Value> sequence = when->list() ? *when->list() : std::vector<Value>{*when};
  if (sequence.empty()) refuse_("'when' must have an event, one of " + event_examples, *when);
  const double first = static_cast<double>(all.events.size()) / LayerEvent::size;
  all.ways.insert(all.ways.end(), {from, to, first, static_cast<double>(sequence.size())});
  for (const Value& event : sequence) {
    std::vector<double> numbers = read_event(event);
    numbers.resize(LayerEvent::size, 0.0);
    all.events.insert(all.events.end(), numbers.begin(), numbers.end());
  }
}

std::vector<double> LayerReader::read_event(const Value& tree) const {
  if (tree.find("pass")) return read_pass(tree);
  if (tree.find("cross")) return read_cross(tree);
  for (const auto& [key, kind] : {std::pair{"enter", LayerEvent::enters}, {"leave", LayerEvent::leaves}}) {
    if (!tree.find(key)) continue;
    allow(tree, {key});
    return {static_cast<double>(kind), read_index(tree.find(key), tree, key, regions_)};
  }
  if (!tree.find("after")) refuse_("an event is one of " + event_examples, tree);
  allow(tree, {"after"});
  return {LayerEvent::elapses, read_quantity(tree.find("after"), tree, "after", "s")};
}

std::vector<double> LayerReader::read_pass(const Value& tree) const {
  allow(tree, {"pass", "within"});
  const std::vector<double> point = read_point(tree.find("pass"), tree);
  const double within = read_quantity(tree.find("within"), tree, "within", "m");
  if (!(within > 0.0)) refuse_("'within' must be above 0, or the point is never passed", tree);
  return {LayerEvent::passes, point[0], point[1], within};
}

std::vector<double> LayerReader::read_cross(const Value& tree) const {
  allow(tree, {"cross", "toward"});
  const Value& line = *tree.find("cross");
  if (!line.list() || line.list()->size() != 2) refuse_("'cross' is a line between two points", line);
  const std::vector<double> a = read_point(&line.list()->front(), line),
                            b = read_point(&line.list()->back(), line);
  if (a == b) refuse_("both ends of the line are the same point", line);
  const Value* toward = tree.find("toward");
  if (!toward || !toward->text() || (*toward->text() != "left" && *toward->text() != "right"))
    refuse_("'toward' must be left or right, as seen from the first end of the line to the second", tree);
  return {LayerEvent::crosses, a[0], a[1], b[0], b[1], *toward->text() == "left" ? 1.0 : -1.0};
}

std::vector<double> LayerReader::read_point(const Value* tree, const Value& event) const {
  if (!tree->list() || tree->list()->size() != 2)
    refuse_("a point is two lengths, as [0 mm, 220 mm]", tree->list() ? *tree : event);
  return {read_quantity(&tree->list()->front(), event, "x", "m"),
          read_quantity(&tree->list()->back(), event, "y", "m")};
}

double LayerReader::read_index(const Value* tree, const Value& owner, const std::string& what,
                               Index most) const {
  const double number = tree && tree->text() ? quantity_in(*tree->text(), "1") : std::nan("");
  if (!(number == std::floor(number) && number >= 1.0 && number <= static_cast<double>(most)))
    refuse_(most > 0 ? fmt::format("'{}' must be a whole number from 1 to {}", what, most)
                     : fmt::format("'{}' needs a distance from a region at the input 'regions'", what),
            tree ? *tree : owner);
  return number - 1.0;
}

double LayerReader::read_quantity(const Value* tree, const Value& owner, const std::string& what,
                                  const std::string& unit) const {
  const double number = tree && tree->text() ? quantity_in(*tree->text(), unit) : std::nan("");
  if (!std::isfinite(number))
    refuse_(fmt::format("{} must be a number in {}", what, unit), tree ? *tree : owner);
  return number;
}

void LayerReader::allow(const Value& tree, const std::vector<std::string>& keys) const {
  for (const auto& [key, value] : *tree.map())
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      refuse_(fmt::format("there is no '{}' here; it has: {}", key, fmt::join(keys, ", ")), value);
}

}  // namespace stepwire
