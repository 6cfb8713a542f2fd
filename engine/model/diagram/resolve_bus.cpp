// Resolution of names of buses and their fields.
#include <fmt/format.h>

#include <algorithm>

#include "engine/model/diagram/bus_fields.hpp"
#include "engine/model/diagram/report.hpp"
#include "engine/model/diagram/resolve.hpp"

namespace stepwire::diagram {

namespace {

constexpr std::size_t max_fields = 1000;

std::vector<std::string> field_names(const BusFields& bus) {
  std::vector<std::string> names;
  for (const BusField& field : bus) names.push_back(field.name);
  return names;
}

}  // namespace

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
