#include "engine/model/diagram/load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "engine/base/math/elementary.hpp"
#include "engine/model/diagram/bus_fields.hpp"
#include "engine/model/diagram/head.hpp"
#include "engine/model/diagram/open.hpp"
#include "engine/model/diagram/report.hpp"
#include "engine/model/diagram/resolve.hpp"
#include "engine/model/diagram/scope.hpp"
#include "engine/model/diagram/units.hpp"

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
    } else if (unit->scale != 1.0L || unit->offset != 0.0L) {
      report.add(
          scope.at(entry.value.mark), subject,
          yaml::fault_text("numbers are in SI and stay as they are, so that {} would be wrong; write {}, "
                           "and convert numbers in {} by a Gain",
                           entry.value.text, unit::si_name(unit->dimension), entry.value.text));
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
    if (written) output.safe_each = written->each;
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

/// Adds the units and shapes that all files declare for ports, signals and fields of buses.
void demand_units_and_shapes(const Scope& scope, const Resolver& resolver, Report& report) {
  demand_named_units(scope, resolver, report);
  demand_inputs(scope, resolver, report);
  demand_outputs(scope, resolver, report);
  demand_of_buses(scope, resolver, report);
  for (const auto& [name, named] : scope.names)
    if (named.part) demand_units_and_shapes(*named.part, resolver, report);
}

/// Reads the outputs of the diagram itself, with their safe values for the time after the run.
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

/// Lists the signals of the ports of parts and of the fields of buses. Faults of unused ports are not
/// reported.
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

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/// True where the name is a word of the text, with or without '$'.
bool mentions(const std::string& text, const std::string& name) {
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    const bool begins = at == 0 || (!is_word(text[at - 1]) && text[at - 1] != '.');
    if (begins && (at + name.size() == text.size() || !is_word(text[at + name.size()]))) return true;
  }
  return false;
}

/// True for keys with texts for readers.
bool is_prose(const std::string& key) {
  return key == "that" || key == "title" || key == "label" || key == "caption" || key == "doc" ||
         key == "text";
}

bool mentions(const yaml::Node& node, const std::string& name) {
  const auto in = [&](const yaml::Node& child) { return mentions(child, name); };
  return mentions(node.text, name) || std::any_of(node.items.begin(), node.items.end(), in) ||
         std::any_of(node.entries.begin(), node.entries.end(), [&](const yaml::Entry& entry) {
           return is_prose(entry.key) ? mentions(entry.value.text, "$" + name) : in(entry.value);
         });
}

/// True for uses in figures, scenes, claims, fits, tunings and studies, which read parameters only after the
/// diagram is built.
bool is_drawn_or_claimed(const yaml::Node& root, const std::string& name) {
  for (const char* key : {"figure", "scene", "claims", "invariants", "fit", "tune", "study", "sensitivity"})
    if (const yaml::Node* node = root.find(key); node && mentions(*node, name)) return true;
  const yaml::Node* sweep = root.find("sweep");
  const yaml::Node* one = sweep ? sweep->find("one_at_a_time") : nullptr;
  const yaml::Node* keep = sweep ? sweep->find("keep") : nullptr;
  return sweep && (sweep->find(name) || (one && one->find(name)) || (keep && mentions(*keep, name)));
}

void refuse_unused(const Scope& scope, std::set<const yaml::Document*>& seen, Report& report) {
  if (!seen.insert(scope.document).second) return;  // a part used twice is reported once
  const yaml::Node& root = scope.document->root;
  if (const yaml::Node* parameters = root.find("parameters"))
    for (const yaml::Entry& entry : parameters->entries)
      if (!scope.parameters.used(entry.key) && !is_drawn_or_claimed(root, entry.key))
        report.add(scope.at(entry.mark), scope.prefix + entry.key,
                   fmt::format("nothing uses this parameter; use it as ${}, or take it out", entry.key));
  for (const auto& [name, named] : scope.names)
    if (named.part) refuse_unused(*named.part, seen, report);
}

/// Reports unused parameters of a file and its parts: no value, expression, part, figure, claim or sweep
/// refers to them. A change of such a parameter would have no effect, so it is a mistake or a remainder.
void refuse_unused_parameters(const Scope& scope, Report& report) {
  std::set<const yaml::Document*> seen;
  refuse_unused(scope, seen, report);
}

void connect(const PendingInput& pending, const Resolver& resolver, Report& report) {
  DiagramBlock& block = report.diagram().blocks[static_cast<std::size_t>(pending.block)];
  const InputSpec& spec = block.type().inputs[static_cast<std::size_t>(pending.input)];
  auto& sources = block.inputs[static_cast<std::size_t>(pending.input)];
  const std::string subject = block.name + "." + spec.name;
  const auto connect_one = [&](const yaml::Node& node) {
    auto source = resolver.source(node, *pending.scope, subject);
    if (!source) return;
    if (source->text) {
      report.bindings().bindings.push_back(*source->text);
      report.bindings().bindings.back().target = {Target::Kind::constant, pending.block, pending.input,
                                                  static_cast<int>(sources.size())};
      source->text.reset();
    }
    sources.push_back(std::move(*source));
  };
  const yaml::Node& node = *pending.node;
  if (spec.list && node.is_list()) {
    if (node.items.empty())
      report.add(pending.scope->at(node.mark), subject, "is an empty list; name at least one signal");
    for (const yaml::Node& item : node.items) connect_one(item);
  } else {
    connect_one(node);
  }
}

void require_inputs(Report& report) {
  for (const DiagramBlock& block : report.diagram().blocks)
    for (std::size_t i = 0; i < block.inputs.size(); ++i) {
      const InputSpec& spec = block.type().inputs[i];
      if (!spec.optional && block.input_marks[i].line == 0)
        report.add(block.origin, block.name,
                   fmt::format("the input '{}' is missing ({})", spec.name, spec.doc));
    }
}

/// Moves the parameters of a file and its parts to the bindings, by the index of their scopes.
void take_parameters(Scope& scope, Bindings& bindings) {
  bindings.scopes[static_cast<std::size_t>(scope.index)] = std::move(scope.parameters);
  for (auto& [name, named] : scope.names)
    if (named.part) take_parameters(*named.part, bindings);
}

enum class Extent { whole_file, one_run };

/// Reads the blocks of a file and its parts, and all that refers to them.
void read_sections(Scope& root, Opener& opener, Settings& settings, Report& report, Extent extent) {
  opener.open(root, {});
  opener.join_guards();
  read_head(root, settings, report);
  if (extent == Extent::whole_file) read_head_of_file(root, report);
  const Resolver resolver(report);
  opener.copy_for_buses(root);
  for (const PendingInput& pending : opener.pending()) connect(pending, resolver, report);
  require_inputs(report);
  read_record(root, resolver, report);
  read_outputs(root, resolver, report);
  read_stop_condition(root, resolver, report);
  demand_units_and_shapes(root, resolver, report);
  settings.report_unused(report);
  if (report.faults().empty()) refuse_unused_parameters(root, report);  // a fault may hide uses
}

/// True for a file whose `functions` are those of the C library. Its expressions are evaluated before its
/// head is read.
bool uses_libm(const yaml::Node& root) {
  const yaml::Node* functions = root.find("functions");
  return functions && functions->text == "libm";
}

/// A diagram under construction from its document.
class Building {
 public:
  explicit Building(const yaml::Document& document) : report_(diagram_) {
    root_.document = &document;
    diagram_.file = document.file;
    diagram_.scopes.push_back({document.file, "", {-1, {}}});
  }
  Building(const Building&) = delete;

  /// Reads the document and collects its faults; throws Error after faults that prevent further reading.
  void read(Loader& loader, const std::vector<Setting>& given, Extent extent) {
    const fn::Selection selection(uses_libm(root_.document->root));
    Settings settings(given, report_);
    check_head_keys(root_, report_);
    Opener opener(loader, settings, report_);
    if (root_.document->root.is_map()) read_sections(root_, opener, settings, report_, extent);
  }
  const yaml::Faults& faults() const { return report_.faults(); }

  Diagram take() {
    Report unsaid(diagram_);
    name_ports(root_, Resolver(unsaid), diagram_);
    report_.bindings().scopes.resize(diagram_.scopes.size());
    take_parameters(root_, report_.bindings());
    diagram_.bindings = std::make_shared<const Bindings>(std::move(report_.bindings()));
    return std::move(diagram_);
  }

 private:
  Diagram diagram_;
  Report report_;
  Scope root_;
};

Diagram build(Loader& loader, const yaml::Document& document, const std::vector<Setting>& given,
              Extent extent = Extent::whole_file) {
  Building building(document);
  building.read(loader, given, extent);
  building.faults().throw_if_any();
  return building.take();
}

}  // namespace

const yaml::Document& Loader::document(const std::string& path) {
  auto& slot = documents_[path];
  if (!slot)
    slot = reader_ ? reader_(path, limits_)
                   : std::make_shared<const yaml::Document>(yaml::read_document(path, limits_));
  return *slot;
}

void Loader::add(yaml::Document document) {
  auto& slot = documents_[document.file];
  slot = std::make_shared<const yaml::Document>(std::move(document));
}

std::vector<std::string> Loader::paths() const {
  std::vector<std::string> paths;
  for (const auto& [path, document] : documents_) paths.push_back(path);
  return paths;
}

Diagram Loader::load(const std::string& path, const std::vector<Setting>& settings) {
  return build(*this, document(path), settings);
}

Diagram Loader::load_point(const std::string& path, const std::vector<Setting>& settings) {
  return build(*this, document(path), settings, Extent::one_run);
}

UnfinishedDiagram Loader::draft(const std::string& path) {
  Building building(document(path));
  std::vector<yaml::Fault> faults;
  try {
    building.read(*this, {}, Extent::whole_file);
    faults = building.faults().list();
  } catch (const yaml::Error& error) {
    faults = error.faults();
  }
  UnfinishedDiagram draft{building.take(), yaml::Error(std::move(faults)).faults()};
  Report units(draft.diagram);
  try {
    draft.input_units = infer_input_units(units);
  } catch (const yaml::Error&) {  // more units disagree than a list of faults may have
  }
  if (draft.faults.empty()) draft.faults = yaml::Error(units.faults().list()).faults();
  return draft;
}

Diagram Loader::load_text(std::string_view text, const std::string& file,
                          const std::vector<Setting>& settings) {
  const yaml::Document document = yaml::parse_document(text, file, limits_);
  return build(*this, document, settings);
}

}  // namespace stepwire::diagram
