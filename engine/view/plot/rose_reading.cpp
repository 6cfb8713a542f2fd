#include "engine/analyse/query/number.hpp"
#include "engine/view/plot/overlay.hpp"

namespace stepwire {
namespace {

void read_place(const Node& node, const Panel& panel, const NamesReading& read, Rose& rose) {
  const auto number = [&](const Node& value, const std::string& axis, const std::string& key) {
    return read_axis_number(value, panel, axis, read.names, read.subject + "." + key, read.faults);
  };
  const Node& radius = *node.find("radius");
  rose.radius = number(radius, "x", "radius").value_or(1.0);
  if (!(rose.radius > 0.0)) below(read, "radius").fault(radius.mark, "the radius of a rose is above 0");
  const Node* at = node.find("at");
  const auto* place = at ? below(read, "at").pair(*at, *rose_form().find("at")) : nullptr;
  if (!place) return;
  const auto x = number((*place)[0], "x", "at"), y = number((*place)[1], "y", "at");
  if (x && y) rose.at = {*x, *y};
}

void read_rose(const Node& node, Panel& panel, const NamesReading& read) {
  const std::size_t before = read.faults.size();
  if (!read.check(node, rose_form()) || read.faults.size() > before) return;
  auto x = read_coordinate(*node.find("x"), "x", panel, below(read, "x"));
  auto y = read_coordinate(*node.find("y"), "y", panel, below(read, "y"));
  auto angle = below(read, "angle").formula(*node.find("angle"));
  auto value = below(read, "value").series(*node.find("value"));
  if (!x || !y || !angle || !value) return;
  Rose rose{std::move(*x), std::move(*y), {*angle, Unit{}, "", angle->text}, std::move(*value)};
  read_place(node, panel, read, rose);
  if (const Node* where = node.find("where")) rose.where = below(read, "where").formula(*where);
  if (const Node* name = node.find("name")) rose.name = below(read, "name").text(*name);
  rose.recording = common_recording({&rose.x.formula, &rose.y.formula, &rose.angle.formula,
                                     &rose.value.formula, rose.where ? &*rose.where : nullptr},
                                    read.names, node, read.subject, read.faults);
  panel.roses.push_back(std::move(rose));
}

}  // namespace

void read_roses(const Node& node, Panel& panel, const NamesReading& read) {
  for (const Node& item : node.as_list()) read_rose(item, panel, read);
}

}  // namespace stepwire
