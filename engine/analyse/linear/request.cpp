#include "engine/analyse/linear/request.hpp"

#include <fmt/format.h>

#include <charconv>
#include <map>

#include "engine/model/diagram/named_signals.hpp"

namespace stepwire::linear {

namespace {

std::map<std::string, diagram::SignalRef> all_signals(const diagram::Diagram& diagram) {
  auto all = diagram::named_signals(diagram);
  for (const diagram::DiagramInput& input : diagram.inputs)
    all.emplace(input.name, diagram::SignalRef{input.block, 0, -1});
  return all;
}

/// Splits "v.2" into "v" and 1.
std::optional<std::pair<std::string, Eigen::Index>> element_of(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos || dot + 1 == name.size()) return std::nullopt;
  Eigen::Index number = 0;
  const char* const end = name.data() + name.size();
  const auto read = std::from_chars(name.data() + dot + 1, end, number);
  if (read.ec != std::errc{} || read.ptr != end || number < 1) return std::nullopt;
  return std::pair{name.substr(0, dot), number - 1};
}

}  // namespace

std::optional<Signal> find_signal(const diagram::Diagram& diagram, const WrittenName& written,
                                  yaml::Faults& faults) {
  const auto all = all_signals(diagram);
  if (const auto found = all.find(written.name); found != all.end())
    return Signal{written.name, found->second};
  if (const auto part = element_of(written.name))
    if (const auto found = all.find(part->first); found != all.end())
      return Signal{written.name, found->second, part->second};
  std::vector<std::string> names;
  for (const auto& [name, signal] : all) names.push_back(name);
  faults.add({written.place,
              written.subject,
              fmt::format("there is no signal '{}'", written.name) +
                  yaml::nearest_or_all(written.name, names, "signals are"),
              {}});
  return std::nullopt;
}

std::optional<Signal> find_wire(const diagram::Diagram& diagram, const WrittenName& written,
                                yaml::Faults& faults) {
  auto found = find_signal(diagram, written, faults);
  if (!found || found->signal.output >= 0) return found;
  const diagram::DiagramBlock& block = diagram.blocks[static_cast<std::size_t>(found->signal.block)];
  const std::string& state = block.type().states[static_cast<std::size_t>(found->signal.state)].name;
  for (std::size_t o = 0; o < block.type().outputs.size(); ++o)
    if (block.type().outputs[o].state == state) {
      found->signal = {found->signal.block, static_cast<int>(o), -1};
      return found;
    }
  faults.add({written.place,
              written.subject,
              yaml::fault_text("'{}' is a state that no wire carries; name an output of '{}'", written.name,
                               block.name),
              {}});
  return std::nullopt;
}

}  // namespace stepwire::linear
