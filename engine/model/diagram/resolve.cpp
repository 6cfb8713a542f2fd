#include "engine/model/diagram/resolve.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/model/diagram/bus_fields.hpp"
#include "engine/model/diagram/element_index.hpp"
#include "engine/model/diagram/output_names.hpp"
#include "engine/model/diagram/report.hpp"

namespace stepwire::diagram {

namespace {

std::vector<std::string> output_names(const BlockType& type) {
  std::vector<std::string> names;
  for (const OutputSpec& output : type.outputs) names.push_back(output.name);
  return names;
}

/// Returns the message about an unknown block. A reference may be a block or one of its outputs, and names of
/// blocks may have dots.
yaml::Message no_block(const std::string& text, const Scope& scope) {
  std::vector<std::string> plain, dotted;
  for (std::string& name : scope.block_names())
    (name.find('.') == std::string::npos ? plain : dotted).push_back(std::move(name));
  const std::string first = text.substr(0, text.find('.')), owner = text.substr(0, text.rfind('.'));
  for (const auto& [name, names] :
       {std::pair(first, &plain), std::pair(text, &dotted), std::pair(owner, &dotted)})
    if (const yaml::Message cure = yaml::did_you_mean(name, *names); !cure.empty())
      return fmt::format("there is no block '{}'", name) + cure;
  return fmt::format("there is no block '{}'", first);
}

std::string without_outputs(const DiagramBlock& block) {
  return fmt::format("'{}' ({}) has no output", block.name, block.type().name);
}

std::string no_single_output(const DiagramBlock& block) {
  if (block.type().outputs.empty()) return without_outputs(block);
  return fmt::format("'{}' has several outputs; say which: {}.{}", block.name, block.name,
                     fmt::join(output_names(block.type()), fmt::format(", {}.", block.name)));
}

yaml::Message no_such_output(const DiagramBlock& block, const std::string& name) {
  const auto names = output_names(block.type());
  if (names.empty()) return without_outputs(block);
  return fmt::format("{} has no output '{}'", block.type().name, name) +
         yaml::did_you_mean(name, names, fmt::format("It has: {}", fmt::join(names, ", ")));
}

yaml::Message no_output_of_part(const std::string& part, const std::string& rest,
                                const std::vector<std::string>& names) {
  if (names.empty())
    return fmt::format("'{}' is a part without outputs; its file names them under 'outputs:'", part);
  if (rest.empty())
    return fmt::format("'{}' has several outputs; say which: {}.{}", part, part,
                       fmt::join(names, fmt::format(", {}.", part)));
  return fmt::format("'{}' has no output '{}'", part, rest) +
         yaml::did_you_mean(rest, names, fmt::format("It has: {}", fmt::join(names, ", ")));
}

std::string wired_to_itself(const std::string& text) {
  return fmt::format("'{}' is wired to itself through ports only, with no block in between", text);
}

// Encodes a state in a Source as an output number below -1.
int encode_state(int state) {
  return -2 - state;
}

// Resolution of names of buses and their fields.

constexpr std::size_t max_fields = 1000;

std::vector<std::string> field_names(const BusFields& bus) {
  std::vector<std::string> names;
  for (const BusField& field : bus) names.push_back(field.name);
  return names;
}

}  // namespace

bool names_signal(const yaml::Node& node) {
  if (!node.is_scalar() || node.text.starts_with('$') || node.text.starts_with('=')) return false;
  return node.quoted || !(unit::parse_quantity(node.text) || means_not_finite(node.text));
}

std::nullopt_t Resolver::refuse(const Query& query, yaml::Message message) const {
  report_.add(query.origin, query.subject, std::move(message));
  return std::nullopt;
}

std::optional<Source> Resolver::source(const yaml::Node& node, const Scope& scope,
                                       const std::string& subject) const {
  return element(node, scope, {scope.at(node.mark), scope.at(node.mark), subject, false});
}

std::optional<Source> Resolver::source(const std::string& name, const Scope& scope, const Origin& origin,
                                       const std::string& subject) const {
  return reference(name, scope, {origin, origin, subject, false});
}

std::optional<SignalRef> Resolver::signal(const std::string& text, const Scope& scope, const Origin& origin,
                                          const std::string& subject) const {
  const auto found = reference(text, scope, {origin, origin, subject, true});
  if (!found) return std::nullopt;
  if (found->block < 0) {
    report_.add(origin, subject, fmt::format("'{}' is a constant number here, not a signal", text));
    return std::nullopt;
  }
  if (found->output >= 0) return SignalRef{found->block, found->output, -1, found->element};
  return SignalRef{found->block, -1, -2 - found->output, found->element};
}

std::optional<Source> Resolver::element(const yaml::Node& node, const Scope& scope, Query query) const {
  if (node.kind == yaml::Node::Kind::empty)
    return refuse(query, "is fed by nothing; name a block or give a number");
  if (names_signal(node)) return reference(node.text, scope, std::move(query));
  if (std::any_of(node.items.begin(), node.items.end(), names_signal))
    return refuse(query, "takes one signal, not a list; join signals with a Mux");
  if (node.is_map() && !node.find("value"))
    return refuse(query, "takes one signal, and this is a bus; name a field of it");
  ParameterUses uses;
  const ValueReader reader(scope.parameters, report_, scope.index, &uses);
  const auto written = reader.read_for(numbers_of_any_unit(), {}, node, query.subject);
  if (!written) return std::nullopt;
  Source source{
      -1,     -1, std::get<Eigen::VectorXd>(written->value.content), written->dimension, scope.at(node.mark),
      nullptr};
  source.columns = written->columns;
  source.each = written->each;
  if (!uses.empty())
    source.text =
        std::make_shared<const Binding>(Binding{{}, {node, scope.index, scope.index}, std::move(uses)});
  return source;
}

std::optional<Source> Resolver::reference(const std::string& text, const Scope& scope, Query query) const {
  if (++query.hops > max_hops) return refuse(query, wired_to_itself(text));
  if (scope.inputs.contains(text)) return port(scope, text, std::move(query));
  std::string whole = text;
  if (const ElementIndex index = take_element(whole); !index.is_whole())
    return picked(reference(whole, scope, query), index, text, query);
  if (const std::string_view port = scope.input_of(text); !port.empty())
    return field_of_port(scope, std::string(port), text.substr(port.size() + 1), std::move(query));
  // In a flattened file hidden blocks are beside the blocks that they guard: ctrl, ctrl.active.
  const std::string_view name = scope.names.contains(text) ? std::string_view(text) : scope.start_of(text);
  if (name.empty()) return refuse(query, no_block(text, scope));
  const auto found = scope.names.find(name);
  if (found == scope.names.end()) return std::nullopt;  // its fault is already reported
  const std::string rest = name.size() == text.size() ? "" : text.substr(name.size() + 1);
  const auto of_named = [&]() -> std::optional<Source> {
    if (found->second.part) return of_part(rest, *found->second.part, std::move(query));
    if (!found->second.bus.empty()) return of_bus(found->second.bus, scope, rest, std::move(query));
    return of_block(rest, found->second.block, query);
  };
  const auto guarded = scope.guarded.find(name);
  if (guarded == scope.guarded.end()) return of_named();
  const std::string output = output_of(rest, found->second);
  if (output.empty() && rest == "active") return output_source(guarded->second.guard, query);
  const int shown = guarded->second.shown(output.empty() ? field_of_output(rest, found->second) : output);
  return shown < 0 ? of_named() : output_source(shown, query);
}

std::string Resolver::field_of_output(const std::string& rest, const Scope::Named& named) {
  if (!named.part || named.part->outputs.size() != 1) return rest;
  const std::string& only = named.part->outputs.begin()->first;
  return rest.starts_with(only + ".") ? rest : only + "." + rest;
}

std::string Resolver::output_of(const std::string& rest, const Scope::Named& named) const {
  if (!named.bus.empty()) return "";
  std::vector<std::string> outputs;
  bool has_one = false;
  if (named.part) {
    for (const auto& [name, out] : named.part->outputs) outputs.push_back(name);
    has_one = outputs.size() == 1;
  } else {
    const BlockType& type = report_.diagram().blocks[static_cast<std::size_t>(named.block)].type();
    outputs = output_names(type);
    has_one = has_one_output(type);
  }
  if (rest.empty()) return has_one ? outputs.front() : "";
  return std::ranges::find(outputs, rest) == outputs.end() ? "" : rest;
}

std::optional<Source> Resolver::output_source(int block, const Query& query) {
  Source source;
  source.block = block;
  source.output = 0;
  source.origin = query.wire;
  return source;
}

std::optional<Source> Resolver::picked(std::optional<Source> source, const ElementIndex& element,
                                       const std::string& text, const Query& query) const {
  if (!source) return std::nullopt;
  // An element is a scalar signal; its only valid element is 1.
  const bool is_single = source->block >= 0 && !source->element.is_whole();
  if (is_single && element != ElementIndex{1, 0})
    return refuse(query, fmt::format("there is no '{}'; it is an element of one element", text));
  if (!is_single) source->element = element;
  return source;
}

std::optional<Source> Resolver::port(const Scope& scope, const std::string& name, Query query) const {
  const Scope::Port& port = scope.inputs.at(name);
  if (port.fed_by) {
    // Faults of a part's input are located at the wire in the using file.
    query.origin = query.wire = scope.parent->at(port.fed_by->mark);
    query.subject = scope.prefix + name;
    return element(*port.fed_by, *scope.parent, std::move(query));
  }
  if (port.block >= 0) {
    Source source;
    source.block = port.block;
    source.output = 0;
    source.origin = query.wire;
    return source;
  }
  if (port.fallback) return element(*port.fallback, scope, std::move(query));
  // A part's input without a source is reported where the part is used; one of a file that runs by itself is
  // reported here.
  if (!scope.parent)
    report_.add(scope.at(port.mark), name,
                "nothing feeds this input; use this file as a part, or give it a 'default:'");
  return std::nullopt;
}

std::optional<Source> Resolver::of_block(const std::string& rest, int block, const Query& query) const {
  const DiagramBlock& found = report_.diagram().blocks[static_cast<std::size_t>(block)];
  const BlockType& type = found.type();
  Source source;
  source.block = block;
  source.origin = query.wire;
  if (rest.empty()) {
    if (!has_one_output(type)) return refuse(query, no_single_output(found));
    source.output = 0;
    return source;
  }
  source.output = type.output(rest);
  if (source.output >= 0) return source;
  const int state = type.state(rest);
  if (state < 0) return refuse(query, no_such_output(found, rest));
  if (!query.look_inside)
    return refuse(query,
                  fmt::format("'{}' is a state inside of {}, not an output; it can be recorded but not wired",
                              rest, type.name));
  source.output = encode_state(state);
  return source;
}

std::optional<Source> Resolver::of_part(const std::string& rest, const Scope& part, Query query) const {
  std::vector<std::string> names;
  for (const auto& [name, out] : part.outputs) names.push_back(name);
  const auto out = rest.empty() && names.size() == 1 ? part.outputs.begin() : part.outputs.find(rest);
  if (out != part.outputs.end()) {
    if (!out->second.signal) return std::nullopt;
    // Faults inside of a part are located in the part's file.
    query.origin = part.at(out->second.signal->mark);
    query.subject = part.prefix + out->first;
    return reference(out->second.signal->text, part, std::move(query));
  }
  for (const auto& [name, port] : part.outputs)
    if (rest.starts_with(name + ".") && port.signal) {
      query.origin = part.at(port.signal->mark);
      query.subject = part.prefix + name;
      return field(*port.signal, part, rest.substr(name.size() + 1), std::move(query));
    }
  if (const yaml::Node* bus = only_bus(part, rest, query.hops)) {
    query.origin = part.at(bus->mark);
    return field(*bus, part, rest, std::move(query));
  }
  const bool inside = query.look_inside && (!part.start_of(rest).empty() || part.inputs.contains(rest));
  if (inside) return reference(rest, part, std::move(query));
  return refuse(query, no_output_of_part(part.prefix.substr(0, part.prefix.size() - 1), rest, names));
}

std::optional<Source> Resolver::field(const yaml::Node& node, const Scope& scope, const std::string& name,
                                      Query query) const {
  if (node.is_map() && !node.find("value"))
    return of_bus(written_fields(node), scope, name, std::move(query));
  if (!names_signal(node)) return refuse(query, fmt::format("has no field '{}'; this is no bus", name));
  return reference(node.text + "." + name, scope, std::move(query));
}

std::optional<Source> Resolver::field(const yaml::Node& node, const Scope& scope, const std::string& name,
                                      const std::string& subject) const {
  return field(node, scope, name, {scope.at(node.mark), scope.at(node.mark), subject, false});
}

std::optional<Source> Resolver::of_bus(const BusFields& bus, const Scope& scope, const std::string& name,
                                       Query query) const {
  for (const BusField& one : bus) {
    const bool is_it = name == one.name;
    if (!is_it && !name.starts_with(one.name + ".")) continue;
    if (one.block >= 0) return of_block(is_it ? "" : name.substr(one.name.size() + 1), one.block, query);
    if (is_it) return element(*one.signal, scope, std::move(query));
    return field(*one.signal, scope, name.substr(one.name.size() + 1), std::move(query));
  }
  const std::vector<std::string> names = field_names(bus);
  const auto inside = names_below(names, name);
  if (!inside.empty())
    return refuse(query, fmt::format("takes one signal, and this is a bus; name a field of it: {}",
                                     fmt::join(inside, ", ")));
  return refuse(query,
                fmt::format("the bus has no field '{}'", name) +
                    yaml::did_you_mean(name, names, fmt::format("It has: {}", fmt::join(names, ", "))));
}

std::optional<Source> Resolver::field_of_port(const Scope& scope, const std::string& name,
                                              const std::string& rest, Query query) const {
  const Scope::Port& port = scope.inputs.at(name);
  if (port.fed_by) {
    query.wire = scope.parent->at(port.fed_by->mark);
    return field(*port.fed_by, *scope.parent, rest, std::move(query));
  }
  if (port.fallback) return field(*port.fallback, scope, rest, std::move(query));
  if (!scope.parent)
    report_.add(scope.at(port.mark), name,
                "nothing feeds this input; use this file as a part, or give it a 'default:'");
  return std::nullopt;
}

const yaml::Node* Resolver::only_bus(const Scope& part, const std::string& field, int hops) const {
  if (part.outputs.size() != 1) return nullptr;
  const yaml::Node* signal = part.outputs.begin()->second.signal;
  const auto names = signal ? fields(*signal, part, hops) : std::vector<std::string>{};
  const bool is_there = std::ranges::any_of(
      names, [&](const std::string& name) { return name == field || name.starts_with(field + "."); });
  return is_there ? signal : nullptr;
}

std::vector<std::string> Resolver::fields(const yaml::Node& node, const Scope& scope, int hops) const {
  if (hops > max_hops) return {};
  if (node.is_map() && !node.find("value")) return fields_of_bus(written_fields(node), scope, hops + 1);
  if (!names_signal(node)) return {};
  return fields_of_name(node.text, scope, hops + 1);
}

std::vector<std::string> Resolver::fields_of_bus(const BusFields& bus, const Scope& scope, int hops) const {
  std::vector<std::string> all;
  for (const BusField& one : bus) {
    const auto inside = one.signal ? fields(*one.signal, scope, hops) : std::vector<std::string>{};
    if (inside.empty()) all.push_back(one.name);
    for (const std::string& name : inside) all.push_back(one.name + "." + name);
    if (all.size() <= max_fields) continue;
    report_.add(scope.at(one.mark), scope.prefix + one.name,
                fmt::format("is in a bus of more than {} fields, those of the buses in it among them; name "
                            "those that are needed",
                            max_fields));
    report_.faults().throw_if_any();  // stops here: each enclosing bus would double the work
  }
  return all;
}

std::vector<std::string> Resolver::fields_of_name(const std::string& text, const Scope& scope,
                                                  int hops) const {
  if (const std::string port(scope.input_of(text)); !port.empty()) {
    const Scope::Port& input = scope.inputs.at(port);
    const std::string rest = text.size() > port.size() ? text.substr(port.size() + 1) : "";
    if (input.fed_by) return names_below(fields(*input.fed_by, *scope.parent, hops), rest);
    if (input.fallback) return names_below(fields(*input.fallback, scope, hops), rest);
    return {};
  }
  const std::string name(scope.start_of(text));
  const auto found = scope.names.find(name);
  if (found == scope.names.end()) return {};
  const std::string rest = text.size() > name.size() ? text.substr(name.size() + 1) : "";
  if (found->second.part) return fields_of_part(rest, *found->second.part, hops);
  if (!found->second.bus.empty()) return names_below(fields_of_bus(found->second.bus, scope, hops), rest);
  return stores_ ? names_below(stores_(found->second.block, hops), rest) : std::vector<std::string>{};
}

std::vector<std::string> Resolver::fields_of_part(const std::string& rest, const Scope& part,
                                                  int hops) const {
  const bool is_only = rest.empty() && part.outputs.size() == 1;
  for (const auto& [name, out] : part.outputs) {
    if (!out.signal || !(is_only || rest == name || rest.starts_with(name + "."))) continue;
    const std::string below = rest.size() > name.size() ? rest.substr(name.size() + 1) : "";
    return names_below(fields(*out.signal, part, hops), below);
  }
  if (part.outputs.size() == 1 && part.outputs.begin()->second.signal)
    if (auto below = names_below(fields(*part.outputs.begin()->second.signal, part, hops), rest);
        !below.empty())
      return below;
  return part.start_of(rest).empty() && part.input_of(rest).empty() ? std::vector<std::string>{}
                                                                    : fields_of_name(rest, part, hops);
}

}  // namespace stepwire::diagram
