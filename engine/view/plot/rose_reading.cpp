#include <fmt/format.h>

#include "engine/analyse/query/number.hpp"
#include "engine/view/plot/overlay.hpp"

namespace stepwire {
namespace {

const std::string rose_subject = "figure.rose";

/// Reads the keys of one rose; faults are gathered.
class RoseReader {
 public:
  RoseReader(const Node& node, const Panel& panel, const Names& names, Faults& faults)
      : node_(node), panel_(panel), names_(names), faults_(faults) {}

  std::optional<Rose> read() {
    check_keys(node_, rose_keys(), "a rose", names_, rose_subject, faults_);
    for (const FigureKey& key : rose_keys())
      if (key.required && !node_.find(key.name))
        return refuse(node_,
                      fmt::format("'{}' is missing: {{x: at.1, y: at.2, angle: phi, value: force in N, "
                                  "radius: 4 mm}}",
                                  key.name));
    auto x = coordinate("x"), y = coordinate("y");
    auto angle = read_formula(*node_.find("angle"), names_, subject("angle"), faults_);
    auto value = read_series(*node_.find("value"), names_, subject("value"), faults_);
    if (!x || !y || !angle || !value) return std::nullopt;
    Rose rose{std::move(*x), std::move(*y), {*angle, Unit{}, "", angle->text}, std::move(*value)};
    read_place(rose);
    if (const Node* where = node_.find("where"))
      rose.where = read_formula(*where, names_, subject("where"), faults_);
    if (const Node* name = node_.find("name")) rose.name = read_text(*name, names_, subject("name"), faults_);
    rose.recording = common_recording({&rose.x.formula, &rose.y.formula, &rose.angle.formula,
                                       &rose.value.formula, rose.where ? &*rose.where : nullptr},
                                      names_, node_, rose_subject, faults_);
    return rose;
  }

 private:
  static std::string subject(const std::string& key) { return rose_subject + "." + key; }

  std::optional<Rose> refuse(const Node& node, const std::string& message) {
    faults_.add({{names_.file, node.mark}, rose_subject, message, {}});
    return std::nullopt;
  }

  std::optional<Series> coordinate(const std::string& axis) {
    return read_coordinate(*node_.find(axis), axis, panel_, names_, subject(axis), faults_);
  }

  std::optional<double> number(const Node& node, const std::string& axis, const std::string& key) {
    return read_axis_number(node, panel_, axis, names_, subject(key), faults_);
  }

  void read_place(Rose& rose) {
    const Node& radius = *node_.find("radius");
    rose.radius = number(radius, "x", "radius").value_or(1.0);
    if (!(rose.radius > 0.0)) refuse(radius, "the radius of a rose is above 0");
    const Node* at = node_.find("at");
    if (!at) return;
    if (!at->is_list() || at->items.size() != 2) {
      refuse(*at, "a rose stands at two numbers, its x and its y: [0 mm, 20 mm]");
      return;
    }
    const auto x = number(at->items[0], "x", "at"), y = number(at->items[1], "y", "at");
    if (x && y) rose.at = {*x, *y};
  }

  const Node& node_;
  const Panel& panel_;
  const Names& names_;
  Faults& faults_;
};

}  // namespace

void read_roses(const Node& node, Panel& panel, const Names& names, Faults& faults) {
  for (const Node& item : items_of(node))
    if (auto rose = RoseReader(item, panel, names, faults).read()) panel.roses.push_back(std::move(*rose));
}

}  // namespace stepwire
