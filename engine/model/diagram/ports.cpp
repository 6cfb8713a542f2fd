#include "engine/model/diagram/ports.hpp"

#include <fmt/format.h>

#include "engine/model/diagram/bus_fields.hpp"
#include "engine/model/diagram/report.hpp"
#include "engine/model/diagram/resolve.hpp"

namespace stepwire::diagram {

namespace {

/// Adds the units that the section `units` requires of signals.
void demand_named_units(const Scope& scope, const Resolver& resolver, Report& report) {
  const yaml::Node* units = scope.document->root.find("units");
  if (!units) return;
  if (!units->is_map())
    return report.add(scope.at(units->mark), scope.prefix + "units", "must be a map of signal: unit");
  for (const yaml::Entry& entry : units->entries) {
    const std::string subject = scope.prefix + "units." + entry.key;
    const auto unit = unit::parse_unit(entry.value.text);
    if (!unit || !entry.value.is_scalar()) {
      report.add(scope.at(entry.value.mark), subject, fmt::format("'{}' is no unit", entry.value.text));
    } else if (auto source = resolver.source(entry.key, scope, scope.at(entry.mark), subject)) {
      report.diagram().unit_demands.push_back(
          {std::move(*source), unit->dimension, subject, scope.at(entry.value.mark)});
    }
  }
}

/// Adds the declared unit and shape of a port or field as demands on its source.
template <class Declared>
void demand(const Declared& declared, const std::optional<Source>& source, const std::string& name,
            const Origin& origin, Diagram& diagram) {
  if (!source) return;
  if (declared.dimension) diagram.unit_demands.push_back({*source, *declared.dimension, name, origin});
  if (declared.shape)
    diagram.shape_demands.push_back({*source, declared.shape->first, declared.shape->second, name, origin});
}

template <class Declared>
bool demands_any(const Declared& declared) {
  return declared.dimension || declared.shape;
}

/// Checks that all declared fields of a port exist, and adds their demands.
void demand_fields(const BusFields& fields, const yaml::Node& node, const Scope& scope,
                   const std::string& name, const Resolver& resolver, Report& report) {
  for (const BusField& field : fields)
    demand(field, resolver.field(node, scope, field.name, name), name + "." + field.name, scope.at(node.mark),
           report.diagram());
}

void demand_inputs(const Scope& scope, const Resolver& resolver, Report& report) {
  for (const auto& [name, port] : scope.inputs) {
    if (!port.fed_by || !scope.parent || port.fed_by->is_list()) continue;
    const std::string full = scope.prefix + name;
    if (!port.fields.empty()) demand_fields(port.fields, *port.fed_by, *scope.parent, full, resolver, report);
    if (demands_any(port))
      demand(port, resolver.source(*port.fed_by, *scope.parent, full), full,
             scope.parent->at(port.fed_by->mark), report.diagram());
  }
}

void demand_outputs(const Scope& scope, const Resolver& resolver, Report& report) {
  for (const auto& [name, out] : scope.outputs) {
    if (!out.signal) continue;
    const std::string full = scope.prefix + name;
    if (!out.fields.empty()) demand_fields(out.fields, *out.signal, scope, full, resolver, report);
    if (demands_any(out))
      demand(out, resolver.source(*out.signal, scope, full), full, scope.at(out.signal->mark),
             report.diagram());
  }
}

void demand_of_buses(const Scope& scope, const Resolver& resolver, Report& report) {
  for (const auto& [name, named] : scope.names)
    for (const BusField& field : named.bus) {
      const std::string full = scope.prefix + name + "." + field.name;
      if (field.signal && demands_any(field))
        demand(field, resolver.source(*field.signal, scope, full), full, scope.at(field.signal->mark),
               report.diagram());
    }
}

/// Reads the output of the diagram itself of this name, or of one of its fields.
void read_output(const std::string& name, const std::string& reference, const Scope::Out& out,
                 const yaml::Node* safe, const Scope& root, const Resolver& resolver, Report& report) {
  const auto signal = resolver.signal(reference, root, root.at(out.signal->mark), name);
  if (!signal) return;
  DiagramOutput output{name, *signal, {}, out.dimension, out.doc, root.at(out.mark)};
  if (safe) {
    const auto written =
        ValueReader(root.parameters, report, root.index).read_for(numbers_of_any_unit(), {}, *safe, name);
    if (written) output.safe = std::get<Eigen::VectorXd>(written->value.content);
    if (written && written->dimension) output.safe_dimension = written->dimension;
  }
  report.diagram().outputs.push_back(std::move(output));
}

/// Returns the value of a field in the map of a bus of values; nullptr if it is missing.
const yaml::Node* value_of_field(const yaml::Node* values, const std::string& name) {
  if (!values || !values->is_map() || values->find("value")) return values;
  for (const BusField& field : written_fields(*values))
    if (field.name == name) return field.signal;
  return nullptr;
}

}  // namespace

void demand_units_and_shapes(const Scope& scope, const Resolver& resolver, Report& report) {
  demand_named_units(scope, resolver, report);
  demand_inputs(scope, resolver, report);
  demand_outputs(scope, resolver, report);
  demand_of_buses(scope, resolver, report);
  for (const auto& [name, named] : scope.names)
    if (named.part) demand_units_and_shapes(*named.part, resolver, report);
}

void read_outputs(const Scope& root, const Resolver& resolver, Report& report) {
  for (const auto* port : in_order_of_file(root.outputs)) {
    const auto& [name, out] = *port;
    if (!out.signal) continue;
    const auto fields = resolver.fields(*out.signal, root);
    if (fields.empty()) read_output(name, out.signal->text, out, out.safe, root, resolver, report);
    for (const std::string& field : fields)
      read_output(name + "." + field, out.signal->text + "." + field, out, value_of_field(out.safe, field),
                  root, resolver, report);
  }
}

namespace {

/// Returns the signals of the fields of a bus; an empty list for other names.
std::vector<std::pair<std::string, SignalRef>> signals_of(const yaml::Node& node, const Scope& scope,
                                                          const Resolver& resolver) {
  std::vector<std::pair<std::string, SignalRef>> signals;
  for (const std::string& field : resolver.fields(node, scope))
    if (const auto signal = resolver.signal(node.text + "." + field, scope, {}, ""))
      signals.emplace_back(field, *signal);
  return signals;
}

yaml::Node named(const std::string& reference) {
  yaml::Node node;
  node.kind = yaml::Node::Kind::scalar;
  node.text = reference;
  return node;
}

void name_bus(const std::string& reference, const std::string& full, const Scope& scope,
              const Resolver& resolver, Diagram& diagram) {
  auto fields = signals_of(named(reference), scope, resolver);
  if (!fields.empty()) diagram.buses.push_back({full, std::move(fields)});
}

/// Lists a port; `reference` is its name in `scope`.
void name_port(const std::string& reference, const std::string& full, const Scope& scope,
               const Resolver& resolver, Diagram& diagram) {
  if (!resolver.fields(named(reference), scope).empty())
    name_bus(reference, full, scope, resolver, diagram);
  else if (const auto signal = resolver.signal(reference, scope, {}, full))
    diagram.part_ports.push_back({full, *signal});
}

}  // namespace

void name_ports(const Scope& scope, const Resolver& resolver, Diagram& diagram) {
  if (scope.parent) {
    const std::string part = scope.prefix.substr(scope.parent->prefix.size());
    for (const auto& [port, in] : scope.inputs)
      name_port(port, scope.prefix + port, scope, resolver, diagram);
    for (const auto& [port, out] : scope.outputs)
      if (out.signal) name_port(part + port, scope.prefix + port, *scope.parent, resolver, diagram);
  }
  for (const auto& [name, what] : scope.names) {
    if (!what.bus.empty()) name_bus(name, scope.prefix + name, scope, resolver, diagram);
    if (what.part) name_ports(*what.part, resolver, diagram);
  }
}

}  // namespace stepwire::diagram
