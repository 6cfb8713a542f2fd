#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/analyse/query/number.hpp"
#include "engine/analyse/tuning/tune_keys.hpp"

namespace stepwire::tuning {

using yaml::form;

namespace {

using ParameterTable = yaml::KeyTable<TuneParameter, TuneReading>;

/// Returns the row of a number in the parameter's unit.
ParameterTable::Row number_row(std::string name, std::string doc, double TuneParameter::*member) {
  return {std::move(name), std::move(doc), form::computed(),
          [member](TuneParameter& parameter, const yaml::Node& node, const TuneReading& read) {
            const auto found = query::read_number(node, read.names, read.subject, read.faults);
            if (!found) return;
            query::check_dimension(*found, {parameter.dimension}, "the parameter", node, read.names,
                                   read.subject, read.faults);
            if (!parameter.dimension) parameter.dimension = found->dimension;
            if (parameter.unit.empty()) parameter.unit = found->unit;
            if (auto wrong = query::bare_number(node.text, parameter.unit, "the parameter"))
              read.fault(node.mark, std::move(*wrong));
            parameter.*member = found->value;
          }};
}

const ParameterTable& parameter_table() {
  static const ParameterTable table(
      "it", "{from: 0.1, to: 10, start: 1}",
      {yaml::needed(number_row("from", "it is sought from this value on", &TuneParameter::lower)),
       yaml::needed(number_row("to", "and up to this one", &TuneParameter::upper)),
       number_row("start", "where the search begins; the file's value without it", &TuneParameter::start),
       {"scale",
        "by equal steps or by equal factors; auto: by factors where the ends are more than tenfold apart",
        form::word({"auto", "linear", "log"}), &TuneParameter::scale}});
  return table;
}

/// Checks that the bounds and the start are consistent.
void check(const TuneParameter& parameter, const yaml::Node& node, const std::string& start,
           const TuneReading& read) {
  const yaml::Node *from = node.find("from"), *to = node.find("to");
  if (!from || !to) return;
  if (!(parameter.lower < parameter.upper) || !std::isfinite(parameter.upper - parameter.lower))
    return read.fault(from->mark, fmt::format("'from: {}' is not below 'to: {}'", from->text, to->text));
  if (parameter.scale == TuneScale::logarithmic && !(parameter.lower * parameter.upper > 0.0))
    read.fault(
        node.find("scale")->mark,
        fmt::format("a logarithm needs ends of one sign and none at 0, not {} and {}", from->text, to->text));
  if (parameter.start < parameter.lower || parameter.start > parameter.upper)
    read.fault(node.find("start") ? node.find("start")->mark : node.mark,
               fmt::format("the start, {}, lies outside of {} to {}; give a 'start' within", start,
                           from->text, to->text));
}

yaml::Message unknown(const std::string& name, const diagram::Diagram& diagram) {
  std::vector<std::string> all;
  for (const diagram::DiagramParameter& one : diagram.parameters)
    if (std::holds_alternative<double>(one.value.content)) all.push_back(one.name);
  return fmt::format("there is no parameter '{}'", name) + yaml::nearest_or_all(name, all, "there are");
}

bool is_swept(const std::string& name, const diagram::Diagram& diagram) {
  return diagram.sweep && std::ranges::find(diagram.sweep->axes, name, &diagram::Sweep::Axis::parameter) !=
                              diagram.sweep->axes.end();
}

/// Returns the unit of the parameter's own value in the file; empty if that is a formula or has none.
std::string unit_of(const diagram::DiagramParameter& parameter, const TuneReading& read) {
  yaml::Node node;
  node.kind = yaml::Node::Kind::scalar;
  node.text = parameter.text;
  yaml::Faults none;
  const auto number = query::read_number(node, read.names, read.subject, none);
  return number ? number->unit : "";
}

void read_parameter(TuneRequest& request, const yaml::Entry& entry, const TuneReading& read) {
  const auto of = std::ranges::find(read.diagram.parameters, entry.key, &diagram::DiagramParameter::name);
  if (of == read.diagram.parameters.end()) return read.fault(entry.mark, unknown(entry.key, read.diagram));
  const double* own = std::get_if<double>(&of->value.content);
  if (!own)
    return read.fault(entry.mark, fmt::format("'{}' is no single number, which alone is tuned", of->text));
  if (is_swept(entry.key, read.diagram))
    return read.fault(entry.mark, "is swept, so it is given; take it out of 'sweep' or out of 'tune'");
  TuneParameter parameter{.name = entry.key, .start = *own, .dimension = of->dimension};
  parameter.unit = unit_of(*of, read);
  parameter.place = {read.names.file, entry.mark};
  if (!parameter_table().read(entry.value, parameter, read)) return;
  if (of->set) return;  // the call sets a fixed value
  const yaml::Node* start = entry.value.find("start");
  check(parameter, entry.value, start ? start->text : of->text, read);
  request.parameters.push_back(std::move(parameter));
}

}  // namespace

const yaml::Key& tune_parameter_form() {
  return parameter_table().form;
}

void read_tune_parameters(TuneRequest& request, const yaml::Node& node, const TuneReading& read) {
  if (!node.is_map() || node.entries.empty())
    return read.fault(node.mark, "names what is tuned: {kp: {from: 0.1, to: 10, start: 1}}");
  for (const yaml::Entry& entry : node.entries) read_parameter(request, entry, yaml::below(read, entry.key));
}

}  // namespace stepwire::tuning
