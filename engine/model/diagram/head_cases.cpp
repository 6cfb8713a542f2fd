// Cases of a sweep; the other swept values are run in each of them.
#include "engine/model/diagram/head_cases.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/yaml/yaml_text.hpp"
#include "engine/model/diagram/own_value.hpp"

namespace stepwire::diagram {

namespace {

class CasesReading {
 public:
  CasesReading(const yaml::Node& cases, const Scope& scope, Sweep& sweep, Report& report)
      : cases_(cases), scope_(scope), sweep_(sweep), report_(report) {}

  void read() {
    const std::size_t before = report_.faults().size();
    if (sweep_.together)
      refuse(cases_.mark, "are run at each point of a grid; leave out 'together', or pair all by lists");
    if (!cases_.is_map() || cases_.entries.size() < 2)
      return refuse(cases_.mark,
                    "are two or more by name, and what each sets: {off: {}, on: {current: 1 A}}");
    for (const yaml::Entry& one : cases_.entries) check(one);
    if (report_.faults().size() != before) return;
    for (const yaml::Entry& one : cases_.entries)
      for (const yaml::Entry& set : one.value.entries) add_axis(set);
    add_label();
  }

 private:
  void refuse(const yaml::Mark& mark, const std::string& message) {
    report_.add(scope_.at(mark), "sweep.cases", message);
  }

  void check(const yaml::Entry& one) {
    if (!one.value.is_map() && one.value.kind != yaml::Node::Kind::empty)
      refuse(one.value.mark,
             fmt::format("'{}' is a map of what it sets: {{current: 1 A}}, or {{}}", one.key));
    for (const yaml::Entry& set : one.value.entries)
      if (find(set.key) != sweep_.axes.end())
        refuse(set.mark, fmt::format("'{}' is swept beside the cases; set it there or here", set.key));
  }

  std::vector<Sweep::Axis>::iterator find(const std::string& parameter) {
    return std::ranges::find(sweep_.axes, parameter, &Sweep::Axis::parameter);
  }

  /// Adds an axis with the values of one parameter in all cases, at the first case that sets it.
  void add_axis(const yaml::Entry& first) {
    if (find(first.key) != sweep_.axes.end()) return;
    Sweep::Axis axis{first.key, {}, scope_.at(first.mark), false, Sweep::Group::cases};
    std::vector<std::string> texts;
    std::vector<yaml::Mark> marks;
    for (const yaml::Entry& one : cases_.entries) {
      const yaml::Node* value = one.value.find(first.key);
      texts.push_back(value ? setting_text(*value) : base_value(axis, "sweep.cases." + first.key, report_));
      marks.push_back(value ? value->mark : one.mark);
    }
    axis.values = SweptValues(std::move(texts), std::move(marks));
    sweep_.axes.push_back(std::move(axis));
  }

  void add_label() {
    if (find(case_label) != sweep_.axes.end())
      return refuse(cases_.mark, "have a column 'case'; give what is swept another name");
    std::vector<std::string> names;
    std::vector<yaml::Mark> marks;
    for (const yaml::Entry& one : cases_.entries) {
      names.push_back(one.key);
      marks.push_back(one.mark);
    }
    sweep_.axes.push_back({case_label, SweptValues(std::move(names), std::move(marks)),
                           scope_.at(cases_.mark), true, Sweep::Group::cases});
  }

  const yaml::Node& cases_;
  const Scope& scope_;
  Sweep& sweep_;
  Report& report_;
};

}  // namespace

std::string setting_text(const yaml::Node& node) {
  if (!node.is_scalar()) return yaml::yaml_line(node);
  return node.quoted ? fmt::format("\"{}\"", node.text) : node.text;
}

std::string base_value(const Sweep::Axis& axis, const std::string& subject, Report& report) {
  const auto refuse = [&](const yaml::Message& message) {
    report.add(axis.origin, subject, message);
    return std::string();
  };
  const Diagram& diagram = report.diagram();
  const auto name = find_name(diagram, axis.parameter);
  if (!name)
    return refuse("is no parameter of the file, of its parts or blocks" +
                  nearest_name(diagram, axis.parameter));
  const auto value = own_value(diagram, *name);
  if (!value)
    return refuse("has no value in the file, which each point but those that differ in it has; write one");
  return *value;
}

void read_cases(const yaml::Node& cases, const Scope& scope, Sweep& sweep, Report& report) {
  CasesReading(cases, scope, sweep, report).read();
}

}  // namespace stepwire::diagram
