#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/analyse/estimation/fit_keys.hpp"
#include "engine/analyse/query/number.hpp"
#include "engine/base/unit/meaning.hpp"

namespace stepwire::estimation {

using yaml::form;

namespace {

using ParameterTable = yaml::KeyTable<FitParameter, FitReading>;

double number(const yaml::Node& node, FitParameter& parameter, const FitReading& read) {
  const auto found = query::read_number(node, read.names, read.subject, read.faults);
  if (!found) return 0.0;
  query::check_dimension(*found, parameter.dimension, "the parameter", node, read.names, read.subject,
                         read.faults);
  if (!parameter.dimension) parameter.dimension = found->dimension;
  if (parameter.unit.empty()) parameter.unit = found->unit;
  return found->value;
}

void read_bounds(FitParameter& parameter, const yaml::Node& node, const FitReading& read) {
  if (!node.is_list() || node.items.size() != 2)
    return read.fault(node.mark, "bounds are a lower and an upper one: [1 kg, 5 kg]");
  parameter.lower = number(node.items[0], parameter, read);
  parameter.upper = number(node.items[1], parameter, read);
  if (!(parameter.lower < parameter.upper))
    read.fault(node.mark, fmt::format("the bounds are the wrong way round: {} is not below {}",
                                      node.items[0].text, node.items[1].text));
}

void read_scale(FitParameter& parameter, const yaml::Node& node, const FitReading& read) {
  FitParameter change = parameter;
  if (change.dimension && unit::is_temperature(*change.dimension)) change.dimension->zeros = 0.0;
  parameter.scale = number(node, change, read);
  if (!parameter.dimension) parameter.dimension = change.dimension;
  parameter.unit = change.unit;
  if (!(parameter.scale > 0.0)) read.fault(node.mark, fmt::format("the scale {} is not above 0", node.text));
}

const ParameterTable& parameter_table() {
  static const ParameterTable table(
      "it", "{start: 2 kg, bounds: [1 kg, 5 kg]}",
      {{"start", "where the search begins; the file's value without it", form::computed(),
        [](FitParameter& parameter, const yaml::Node& node, const FitReading& read) {
          parameter.start = number(node, parameter, read);
        }},
       {"bounds", "it is sought between these: [1 kg, 5 kg]", form::pair(form::computed()), read_bounds},
       {"scale", "a change that counts; the size of the start without it", form::computed(), read_scale},
       {"each_record", "true: each record has its own value, else they share one", form::truth(),
        &FitParameter::each_record}});
  return table;
}

/// Sets the defaults of a parameter and checks that its start is within its bounds.
void complete(FitParameter& parameter, const yaml::Node& node, const std::string& start,
              const FitReading& read) {
  const bool ordered = parameter.lower < parameter.upper;
  if (ordered && (parameter.start < parameter.lower || parameter.start > parameter.upper)) {
    const yaml::Node& bounds = *node.find("bounds");
    yaml::below(read, "bounds")
        .fault(bounds.mark,
               fmt::format("the start, {}, is outside of the bounds [{}, {}]; it must lie within them", start,
                           bounds.items[0].text, bounds.items[1].text));
  }
  if (node.find("scale")) return;
  if (parameter.start != 0.0)
    parameter.scale = std::abs(parameter.start);
  else if (parameter.bounded())
    parameter.scale = 0.1 * (parameter.upper - parameter.lower);
}

yaml::Message unknown(const std::string& name, const diagram::Diagram& diagram) {
  std::vector<std::string> all;
  for (const diagram::DiagramParameter& one : diagram.parameters)
    if (std::holds_alternative<double>(one.value.content)) all.push_back(one.name);
  return fmt::format("there is no parameter '{}'", name) + yaml::nearest_or_all(name, all, "there are");
}

void read_parameter(FitRequest& request, const yaml::Entry& entry, const FitReading& read) {
  const auto of = std::ranges::find(read.diagram.parameters, entry.key, &diagram::DiagramParameter::name);
  if (of == read.diagram.parameters.end()) return read.fault(entry.mark, unknown(entry.key, read.diagram));
  const double* own = std::get_if<double>(&of->value.content);
  if (!own)
    return read.fault(entry.mark, fmt::format("'{}' is no single number, which alone is fitted", of->text));
  if (read.is_swept(entry.key))
    return read.fault(entry.mark, "is swept, so it is given; take it out of 'sweep' or out of 'fit'");
  FitParameter parameter{.name = entry.key, .start = *own, .dimension = of->dimension};
  parameter.place = {read.names.file, entry.mark};
  if (!parameter_table().read(entry.value, parameter, read)) return;
  const yaml::Node* start = entry.value.find("start");
  complete(parameter, entry.value, start ? start->text : of->text, read);
  read.parameters.push_back(parameter);
  if (!of->set) request.parameters.push_back(std::move(parameter));  // the call sets a fixed value
}

}  // namespace

bool FitReading::is_swept(const std::string& name) const {
  return diagram.sweep && std::ranges::find(diagram.sweep->axes, name, &diagram::Sweep::Axis::parameter) !=
                              diagram.sweep->axes.end();
}

const yaml::Key& fit_parameter_form() {
  return parameter_table().form;
}

void read_fit_parameters(FitRequest& request, const yaml::Node& node, const FitReading& read) {
  if (!node.is_map() || node.entries.empty())
    return read.fault(node.mark,
                      "names what is to be found: {rig.mass: {start: 2 kg, bounds: [1 kg, 5 kg]}}");
  for (const yaml::Entry& entry : node.entries) read_parameter(request, entry, yaml::below(read, entry.key));
}

}  // namespace stepwire::estimation
