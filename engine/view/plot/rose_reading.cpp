#include "engine/analyse/query/number.hpp"
#include "engine/view/plot/overlay.hpp"

namespace stepwire::plot {
namespace {

void read_place(const yaml::Node& node, const Panel& panel, const query::NamesReading& read, Rose& rose) {
  const auto number = [&](const yaml::Node& value, const std::string& axis, const std::string& key) {
    return read_axis_number(value, panel, axis, read.names, read.subject + "." + key, read.faults);
  };
  const yaml::Node& radius = *node.find("radius");
  rose.radius = number(radius, "x", "radius").value_or(1.0);
  if (!(rose.radius > 0.0)) yaml::below(read, "radius").fault(radius.mark, "the radius of a rose is above 0");
  const yaml::Node* at = node.find("at");
  const auto* place = at ? yaml::below(read, "at").pair(*at, *rose_form().find("at")) : nullptr;
  if (!place) return;
  const auto x = number((*place)[0], "x", "at"), y = number((*place)[1], "y", "at");
  if (x && y) rose.at = {*x, *y};
}

void read_rose(const yaml::Node& node, Panel& panel, const query::NamesReading& read) {
  const std::size_t before = read.faults.size();
  if (!read.check(node, rose_form()) || read.faults.size() > before) return;
  auto x = read_coordinate(*node.find("x"), "x", panel, yaml::below(read, "x"));
  auto y = read_coordinate(*node.find("y"), "y", panel, yaml::below(read, "y"));
  auto angle = yaml::below(read, "angle").formula(*node.find("angle"));
  auto value = yaml::below(read, "value").series(*node.find("value"));
  if (!x || !y || !angle || !value) return;
  Rose rose{std::move(*x), std::move(*y), {*angle, unit::Unit{}, "", angle->text}, std::move(*value)};
  read_place(node, panel, read, rose);
  if (const yaml::Node* where = node.find("where")) rose.where = yaml::below(read, "where").formula(*where);
  if (const yaml::Node* name = node.find("name")) rose.name = yaml::below(read, "name").text(*name);
  rose.recording = query::common_recording({&rose.x.formula, &rose.y.formula, &rose.angle.formula,
                                            &rose.value.formula, rose.where ? &*rose.where : nullptr},
                                           read.names, node, read.subject, read.faults);
  panel.roses.push_back(std::move(rose));
}

}  // namespace

void read_roses(const yaml::Node& node, Panel& panel, const query::NamesReading& read) {
  for (const yaml::Node& item : node.as_list()) read_rose(item, panel, read);
}

}  // namespace stepwire::plot
