#include "engine/app/simulink/placeholder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "engine/app/simulink/plain_text.hpp"
#include "engine/base/yaml/yaml_text.hpp"

namespace stepwire::simulink {

namespace {

/// Returns the type of a block for people: "Reference simulink/Continuous/PID Controller".
std::string type_of(const BlockWriter& write) {
  const std::string library = on_one_line(write.text("SourceBlock"));
  return write.block().type + (library.empty() ? "" : " " + library);
}

/// Returns the parameters of a block as comments.
std::string parameter_comments(const Block& block) {
  std::string text;
  for (const auto& [name, value] : block.texts)
    if (!value.empty() && name != "Position" && name != "ZOrder" && name != "Ports" &&
        !name.starts_with("PortCounts"))
      text += fmt::format("#   {} = {}\n", on_one_line(name), on_one_line(value).substr(0, 500));
  for (const auto& [name, value] : block.mask)
    text += fmt::format("#   {} = {}\n", on_one_line(name), on_one_line(value).substr(0, 500));
  return text;
}

/// Returns the connected ports of a subsystem that control it, each with the name of an input. `enable` and
/// `trigger` are keys of a part, so that these names end in `_port`.
std::vector<std::pair<std::string, std::string>> control_ports(const BlockWriter& write) {
  std::vector<std::pair<std::string, std::string>> ports;
  for (const char* port : {"Reset", "reset", "enable", "trigger", "ifaction"})
    if (write.instance().sources.contains(write.block().sid + "#" + port))
      ports.emplace_back(port, lower_case(port) == "reset" ? "Reset" : std::string(port) + "_port");
  return ports;
}

/// Adds the greatest element that a text reads of each output: of "TOKEN.3".
void add_read(const std::string& text, ElementsRead& read) {
  for (std::size_t at = 0; (at = text.find("\x02.", at)) != text.npos; at += 2) {
    const std::size_t start = text.rfind('\x01', at);
    const int element = std::atoi(text.c_str() + at + 2);
    if (start == text.npos || element < 1 || element > 100'000) continue;
    std::size_t& most = read[*FlatModel::token_of(text.substr(start, at - start + 1))];
    most = std::max(most, static_cast<std::size_t>(element));
  }
}

void add_read(const yaml::Node& node, ElementsRead& read) {
  add_read(node.text, read);
  for (const yaml::Node& item : node.items) add_read(item, read);
  for (const yaml::Entry& entry : node.entries) add_read(entry.value, read);
}

}  // namespace

void use_placeholder(BlockWriter& write, const std::string& reference) {
  const int inputs = write.inputs(), outputs = write.outputs();
  write.make_part(reference);
  for (int i = 1; i <= inputs; ++i) write.key(fmt::format("u{}", i), write.source(i));
  for (const auto& [port, input] : control_ports(write)) write.key(input, write.source(port));
  for (int i = 1; outputs > 1 && i <= outputs; ++i) write.output(i, fmt::format("{}.y{}", write.name(), i));
}

ElementsRead elements_read(const FlatModel& model) {
  ElementsRead read;
  for (const FlatBlock& block : model.blocks()) {
    for (const auto& [name, node] : block.made) add_read(node, read);
    for (const auto& [port, text] : block.outputs) add_read(text, read);
  }
  return read;
}

std::string placeholder_text(const BlockWriter& write, const std::string& reason, std::size_t index,
                             const ElementsRead& read) {
  yaml::Node root, in, out, blocks;
  add(root, "stepwire", word("1"));
  add(root, "title", word(fmt::format("To be written: {}", on_one_line(write.block().name))));
  for (int i = 1; i <= write.inputs(); ++i) add(in, fmt::format("u{}", i), yaml::Node{});
  for (int i = 1; i <= write.outputs(); ++i) {
    const auto found = read.find({index, i});
    const std::size_t width = found == read.end() ? 1 : found->second;
    const std::string nothing = fmt::format("nothing_{}", i);
    add(out, fmt::format("y{}", i), word(nothing));
    const Value zeros = Value::matrix(1, width, 0.0);
    add(blocks, nothing, map_of({{"block", word("Constant")}, {"value", value_node(zeros)}}));
  }
  for (const auto& [port, input] : control_ports(write)) add(in, input, yaml::Node{});
  if (!in.entries.empty()) add(root, "inputs", std::move(in));
  if (!out.entries.empty()) add(root, "outputs", std::move(out));
  add(blocks, fmt::format("write_the_blocks_of_{}_here", valid_name(write.block().name)),
      map_of({{"block", word("Assert")}, {"u", word("0")}}));
  add(root, "blocks", std::move(blocks));
  return fmt::format(
      "# In place of a block of Simulink, {}: {}.\n# Write its blocks here, and remove the Assert.\n{}{}",
      type_of(write), reason, parameter_comments(write.block()), yaml::yaml_text(root));
}

}  // namespace stepwire::simulink
