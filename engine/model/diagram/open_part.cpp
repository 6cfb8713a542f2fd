// Parts: files with ports, used in another file like a block.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "engine/base/yaml/message.hpp"
#include "engine/model/diagram/bare_number.hpp"
#include "engine/model/diagram/bus_fields.hpp"
#include "engine/model/diagram/external_input.hpp"
#include "engine/model/diagram/guard_keys.hpp"
#include "engine/model/diagram/head.hpp"
#include "engine/model/diagram/head_keys.hpp"
#include "engine/model/diagram/open.hpp"
#include "engine/model/diagram/part_file.hpp"
#include "engine/model/diagram/resolve.hpp"

namespace stepwire::diagram {

namespace {

constexpr std::size_t deepest_nesting = 32;
constexpr std::size_t max_parts = 100'000;  // bounds the growth of parts that use parts twice

std::vector<std::string> keys_of_map(const yaml::Node& root, const char* key) {
  std::vector<std::string> names;
  if (const yaml::Node* map = root.find(key))
    for (const yaml::Entry& entry : map->entries) names.push_back(entry.key);
  return names;
}

std::string doc_of(const yaml::Entry& port) {
  const yaml::Node* doc = port.value.is_map() ? port.value.find("doc") : nullptr;
  return doc ? doc->text : "";
}

/// True for a default that is the map of a bus; false for a number with its unit.
bool is_bus(const yaml::Node& node) {
  return node.is_map() && !node.find("value");
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// True for a key that is an input or a parameter of the part's file.
bool is_port_or_parameter(const yaml::Node& root, const std::string& key) {
  return contains(keys_of_map(root, "inputs"), key) || contains(keys_of_map(root, "parameters"), key);
}

/// Makes the scope of a part and lists it in the diagram.
std::unique_ptr<Scope> scope_of_part(Scope& user, const yaml::Entry& entry, const Origin& origin,
                                     const std::string& file, Diagram& diagram) {
  auto part = std::make_unique<Scope>();
  part->index = static_cast<int>(diagram.scopes.size());
  part->parent = &user;
  part->prefix = user.prefix + entry.key + ".";
  diagram.scopes.push_back({file, part->prefix, origin});
  return part;
}

void report_missing_inputs(const Scope& user, const yaml::Entry& entry, const Scope& part, Report& report) {
  for (const auto& [name, port] : part.inputs)
    if (!port.fed_by && !port.fallback)
      report.add(user.at(entry.value.mark), user.prefix + entry.key,
                 fmt::format("the input '{}' is missing", name));
}

}  // namespace

void Opener::declare_ports(Scope& scope) {
  for (const char* key : {"inputs", "outputs"}) {
    const yaml::Node* ports = scope.document->root.find(key);
    if (ports && !ports->is_map())
      report_.add(scope.at(ports->mark), scope.prefix + key, "must be a map of the ports' names");
  }
  if (const yaml::Node* inputs = scope.document->root.find("inputs"))
    for (const yaml::Entry& port : inputs->entries) declare_input(scope, port);
  if (const yaml::Node* outputs = scope.document->root.find("outputs"))
    for (const yaml::Entry& port : outputs->entries) declare_output(scope, port);
}

std::optional<unit::Dimension> Opener::declared_unit(const Scope& scope, const yaml::Entry& port) {
  const yaml::Node* unit = port.value.is_map() ? port.value.find("unit") : nullptr;
  if (!unit) return std::nullopt;
  const auto refuse = [&](const yaml::Mark& mark, const yaml::Message& message) {
    report_.add(scope.at(mark), scope.prefix + port.key, message);
    return std::nullopt;
  };
  if (!unit->is_scalar()) return refuse(unit->mark, "has one unit; a bus has 'fields' with a unit for each");
  const auto parsed = unit::parse_unit(unit->text);
  if (!parsed) return refuse(unit->mark, fmt::format("'{}' is no unit", unit->text));
  for (const char* key : {"default", "safe"})
    if (const yaml::Node* value = port.value.find(key))
      for (const yaml::Node& number : value->as_list())
        if (auto fault = bare_number(number.text, unit->text, "the port"))
          return refuse(number.mark, std::move(*fault));
  return parsed->dimension;
}

std::optional<std::pair<Eigen::Index, Eigen::Index>> Opener::declared_shape(const Scope& scope,
                                                                            const yaml::Entry& port) {
  const yaml::Node* shape = port.value.is_map() ? port.value.find("shape") : nullptr;
  if (!shape) return std::nullopt;
  const auto parsed = parse_shape(shape->text);
  if (!parsed)
    report_.add(scope.at(shape->mark), scope.prefix + port.key,
                yaml::fault_text("'{}' is no shape; write 3, or 3 x 2 for a matrix of 3 rows", shape->text));
  return parsed;
}

void Opener::declare_input(Scope& scope, const yaml::Entry& port) {
  if (port.value.is_map())
    HeadReading(scope.prefix + port.key, scope, report_).check(port.value, input_form().of.back());
  Scope::Port& declared = scope.inputs[port.key];
  declared.dimension = declared_unit(scope, port);
  declared.fallback = port.value.is_map() ? port.value.find("default") : nullptr;
  declared.doc = doc_of(port);
  declared.mark = port.mark;
  if (const yaml::Node* fields = port.value.is_map() ? port.value.find("fields") : nullptr)
    declared.fields = declared_fields(*fields);
  declared.shape = declared_shape(scope, port);
}

void Opener::declare_output(Scope& scope, const yaml::Entry& port) {
  if (port.value.is_map())
    HeadReading(scope.prefix + port.key, scope, report_).check_unknown(port.value, output_form().of.back());
  const yaml::Node* signal = port.value.is_map() ? port.value.find("signal") : &port.value;
  if (!signal || !signal->is_scalar()) {
    const bool is_bus = port.value.is_map() && port.value.find("fields") && !signal;
    report_.add(scope.at(port.value.mark), scope.prefix + port.key,
                is_bus
                    ? "names no signal; a bus is made among the blocks, 'wrench: {fields: {force: f}}', and "
                      "named here"
                    : "names no signal; write the output of a block, as lag.y");
    signal = nullptr;
  }
  const yaml::Node* safe = port.value.is_map() ? port.value.find("safe") : nullptr;
  scope.outputs[port.key] = {signal,    safe, declared_unit(scope, port), doc_of(port),
                             port.mark, {},   declared_shape(scope, port)};
  if (const yaml::Node* fields = port.value.is_map() ? port.value.find("fields") : nullptr)
    scope.outputs[port.key].fields = declared_fields(*fields);
}

/// Splits an input of the diagram itself that is a bus into one input for each field.
void Opener::split_inputs(Scope& scope) {
  std::map<std::string, Scope::Port, std::less<>> fields;
  for (const auto& [name, port] : scope.inputs) {
    if (!port.fallback || !is_bus(*port.fallback)) continue;
    for (const BusField& field : written_fields(*port.fallback)) {
      Scope::Port& own = fields[name + "." + field.name];
      own.fallback = field.signal;
      own.doc = port.doc;
      own.mark = field.mark;
      for (const BusField& declared : port.fields)
        if (declared.name == field.name) own.dimension = declared.dimension, own.shape = declared.shape;
    }
  }
  scope.inputs.merge(fields);
}

void Opener::make_inputs(Scope& scope) {
  split_inputs(scope);
  for (auto* entry : in_order_of_file(scope.inputs)) {
    auto& [name, port] = *entry;
    if (!port.fallback || names_signal(*port.fallback) || is_bus(*port.fallback)) continue;
    const BlockType& type = external_input_type();
    Diagram& diagram = report_.diagram();
    port.block = static_cast<int>(diagram.blocks.size());
    diagram.inputs.push_back({name, port.block, port.doc});
    DiagramBlock& block = diagram.blocks.emplace_back(name, type);
    block.origin = scope.at(port.mark);
    block.parameter_marks.resize(1);
    block.parameter_dimensions.resize(1);
    read_parameter(scope, scope.index, *port.fallback, block, 0);
    read_settings(scope, block, scope.prefix + name);
    if (!port.dimension) continue;
    const EachUnit* const each = block.elements_of(0);
    const auto wrong = each ? wrong_element(*each, port.dimension) : std::nullopt;
    const std::string complaint =
        unit_complaint(wrong ? (*each)[*wrong] : block.parameter_dimensions[0], port.dimension);
    if (!complaint.empty()) report_.add(scope.at(port.fallback->mark), name, complaint);
    block.parameter_dimensions[0] = port.dimension;
    block.parameter_elements.clear();
  }
}

bool Opener::refuse_nesting(Scope& scope, const yaml::Entry& entry, const yaml::Node& path,
                            const std::string& file) {
  const auto circle = std::find(open_files_.begin(), open_files_.end(), file);
  if (circle != open_files_.end()) {
    fail(scope, entry, path.mark,
         fmt::format("this file contains itself: {} -> {}; a part cannot use a file that uses it",
                     fmt::join(circle, open_files_.end(), " -> "), file));
  } else if (open_files_.size() >= deepest_nesting) {
    fail(scope, entry, path.mark, fmt::format("parts are nested more than {} deep here", deepest_nesting));
    report_.faults().throw_if_any();  // stops here: recursive parts would repeat the fault
  } else if (report_.diagram().scopes.size() > max_parts) {
    fail(scope, entry, path.mark, fmt::format("the diagram has more than {} parts here", max_parts));
    report_.faults().throw_if_any();  // stops here: each further part would repeat the fault
  } else if (std::error_code none; std::filesystem::is_other(std::filesystem::status(file, none))) {
    fail(scope, entry, path.mark,
         fmt::format("{} is no file", file));  // reading a pipe or a device would block
  } else {
    return false;
  }
  return true;
}

void Opener::open_part(Scope& scope, const yaml::Entry& entry, const yaml::Node& path) {
  if (!path.is_scalar()) return fail(scope, entry, path.mark, "'diagram:' names a file, as parts/rig.yaml");
  const std::string file = part_file(*scope.document, path.text);
  if (refuse_fetched(scope, entry, path, file) || refuse_nesting(scope, entry, path, file)) return;
  auto named = scope_of_part(scope, entry, scope.at(path.mark), file, report_.diagram());
  Scope& part = *named;
  if (!read_part(scope, entry, path, part)) return;
  scope.names[entry.key] = {-1, std::move(named), entry.mark};
  const yaml::Node& root = part.document->root;
  const auto is_own = [&](const char* key) { return is_port_or_parameter(root, key); };
  const bool is_taken = contains(keys_of_map(root, "blocks"), "active");
  const Guarding guarding = open_guard(scope, entry, is_own, is_taken ? "active_guard" : "active");
  part.guard = guarding.guard >= 0 ? guarding.guard : scope.guard;
  read_period_of_part(scope, entry, is_own, part);
  if (guarding.guard >= 0) {
    DiagramBlock& guard = report_.diagram().blocks[static_cast<std::size_t>(guarding.guard)];
    guard.every = part.every;
    guard.every_origin = part.every_origin;
  }
  const Overrides overrides = feed(scope, entry, path, part);
  open(part, overrides);
  show_outputs(scope, entry, guarding, part);
  report_missing_inputs(scope, entry, part, report_);
}

namespace {

/// Returns the message about a part that cannot be read: for a missing file with the searched folders and the
/// nearest name.
yaml::Message unread_part(const yaml::Document& user, const std::string& path, const std::string& file,
                          const yaml::Message& fault) {
  std::error_code none;
  if (std::filesystem::exists(file, none)) return path + ": " + fault;
  const yaml::Message cure = near_part(user, path);
  return yaml::Message(path + ": " + fault.wrong + (use_of(user.root, path) ? "" : other_part_places(path)),
                       cure.cure, cure.suggestion);
}

}  // namespace

bool Opener::read_part(Scope& scope, const yaml::Entry& entry, const yaml::Node& path, Scope& part) {
  const std::string& file = report_.diagram().scopes[static_cast<std::size_t>(part.index)].file;
  try {
    part.document = &loader_.document(file);
  } catch (const yaml::Error& error) {
    scope.failed.insert(entry.key);
    for (const yaml::Fault& fault : error.faults())
      if (fault.place.mark.line > 0) {
        report_.add(part.at(fault.place.mark), scope.prefix + entry.key, fault.message);
      } else {
        report_.add(scope.at(path.mark), scope.prefix + entry.key,
                    unread_part(*scope.document, path.text, file, fault.message));
      }
    return false;
  }
  check_head_keys(part, report_);
  if (!part.document->root.is_map()) scope.failed.insert(entry.key);
  return part.document->root.is_map();
}

Overrides Opener::feed(const Scope& scope, const yaml::Entry& entry, const yaml::Node& path, Scope& part) {
  Overrides overrides{&scope, {}};
  const auto parameters = keys_of_map(part.document->root, "parameters");
  const auto inputs = keys_of_map(part.document->root, "inputs");
  for (const yaml::Entry& key : entry.value.entries) {
    if (key.key == "diagram" || is_condition(key.key, key.value)) continue;
    if (contains(inputs, key.key)) {
      part.inputs[key.key].fed_by = &key.value;
    } else if (contains(parameters, key.key)) {
      overrides.values[key.key] = &key.value;
    } else if (key.key != "every" && (!is_guard_key(key.key) || key.key == "guard")) {
      std::vector<std::string> all = parameters;
      all.insert(all.end(), inputs.begin(), inputs.end());
      report_.add(scope.at(key.mark), scope.prefix + entry.key,
                  fmt::format("{} has no '{}'", path.text, key.key) +
                      yaml::did_you_mean(key.key, all,
                                         all.empty() ? "It has neither inputs nor parameters"
                                                     : fmt::format("It has: {}", fmt::join(all, ", "))));
    }
  }
  return overrides;
}

}  // namespace stepwire::diagram
