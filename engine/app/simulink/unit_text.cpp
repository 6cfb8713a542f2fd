#include "engine/app/simulink/unit_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "engine/app/simulink/plain_text.hpp"
#include "engine/base/yaml/yaml_text.hpp"

namespace stepwire::simulink {

namespace {

/// Returns the lines of a text with blanks before each.
std::string indented(const std::string& text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    result += "  " + text.substr(at, end - at) + "\n";
    at = end + 1;
  }
  return result;
}

/// Returns the words of letters, digits and '_' in a text.
std::set<std::string> words_of(const std::string& text) {
  std::set<std::string> words;
  std::string one;
  for (const char c : text + " ") {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
      one += c;
    } else if (!one.empty()) {
      words.insert(one);
      one.clear();
    }
  }
  return words;
}

}  // namespace

void UnitTexts::join_units() {
  auto& units = model_.units();
  for (auto unit = units.rbegin(); unit != units.rend(); ++unit) {
    if ((*unit)->parent) outputs_of(**unit);
    keep_used_variables(**unit);
    if ((*unit)->parent) wire_part(**unit);
  }
}

void UnitTexts::outputs_of(Unit& unit) {
  Instance& in = *unit.instance;
  for (const auto& [port, block] : in.outports) {
    std::string source = model_.source(in, *block, "in:1");
    if (!FlatModel::token_of(source)) {  // an output is that of a block
      const std::string name = unit.take_name(valid_name(block->name) + "_passed");
      FlatBlock flat;
      flat.block = block;
      flat.in = &in;
      flat.name = name;
      flat.made.emplace_back(name,
                             map_of({{"block", word("Gain")}, {"u", word(source)}, {"gain", word("1")}}));
      unit.blocks.push_back(model_.blocks().size());
      model_.blocks().push_back(std::move(flat));
      source = name;
    }
    unit.outputs[port] = {valid_name(block->name), source};
  }
}

void UnitTexts::keep_used_variables(Unit& unit) {
  std::string text = blocks_text(unit);
  if (!unit.parent)
    for (const std::string& stop : collected_.stops) text += model_.resolved(stop) + "\n";
  const std::set<std::string> words = words_of(text);
  Workspace& workspace = model_.workspace();
  std::erase_if(unit.variables,
                [&](const std::string& name) { return !words.contains(workspace.variable(name).written); });
}

void UnitTexts::wire_part(Unit& unit) {
  FlatBlock& user = model_.blocks()[unit.instance->parent->flat.at(unit.instance->owner)];
  if (user.made.empty()) return;  // a placeholder
  yaml::Node& node = user.made.back().second;
  for (std::size_t i = 0; i < unit.inputs.size(); ++i)
    if (!unit.inputs[i].empty())
      add(node, unit.inputs[i],
          word(model_.source(*unit.instance->parent, *unit.instance->owner, fmt::format("in:{}", i + 1))));
  for (const auto& [name, source] : unit.tags) add(node, name, word(source));
  for (const std::string& name : unit.variables) {
    const std::string& written = model_.workspace().variable(name).written;
    add(node, written, word("$" + written));
  }
  const bool is_single = unit.outputs.size() == 1;
  for (const auto& [port, block] : unit.instance->outports)
    user.outputs[port] = user.name + (is_single ? "" : "." + valid_name(block->name));
  if (!unit.resets_outputs)
    for (const auto& [port, rest] : unit.rests) replace_output(user, *unit.parent, port, rest);
}

/// Adds a block behind a part, and returns its name.
static std::string add_behind(FlatBlock& part, Unit& in, const std::string& suffix, yaml::Node node) {
  const std::string name = in.take_name(part.name + suffix);
  part.made.emplace_back(name, std::move(node));
  return name;
}

static yaml::Node expression_of(std::vector<yaml::Node> inputs, const std::string& formula) {
  return map_of(
      {{"block", word("Expression")}, {"u", list_of(std::move(inputs))}, {"expression", word(formula)}});
}

/// Returns the block that is 1 from the first run of a part on.
static std::string has_run(FlatBlock& part, Unit& in) {
  if (!part.has_run.empty()) return part.has_run;
  part.has_run = in.take_name(part.name + "_has_run");
  const std::string before =
      add_behind(part, in, "_had_run",
                 map_of({{"block", word("UnitDelay")}, {"u", word(part.has_run)}, {"initial", word("0")}}));
  part.made.emplace_back(part.has_run,
                         expression_of({word(part.name + ".active"), word(before)}, "u1 > 0 || u2 > 0"));
  return part.has_run;
}

void UnitTexts::replace_output(FlatBlock& part, Unit& in, int port, const Rest& rest) {
  const std::string output = part.outputs.at(port);
  const std::string suffix = output == part.name ? "_output" : "_" + output.substr(part.name.size() + 1);
  const std::string when = rest.is_reset ? part.name + ".active" : has_run(part, in);
  yaml::Node initial =
      rest.initial->is_scalar()
          ? cell_node(rest.initial->cells[0])
          : word(add_behind(part, in, suffix + "_initial",
                            map_of({{"block", word("Constant")}, {"value", list_node(*rest.initial)}})));
  part.outputs[port] = add_behind(
      part, in, suffix, expression_of({word(when), word(output), std::move(initial)}, "u1 > 0 ? u2 : u3"));
}

yaml::Node UnitTexts::resolved(const yaml::Node& node) const {
  yaml::Node result = node;
  result.text = model_.resolved(node.text);
  for (yaml::Node& item : result.items) item = resolved(item);
  for (yaml::Entry& entry : result.entries) entry.value = resolved(entry.value);
  return result;
}

std::string UnitTexts::blocks_text(const Unit& unit) const {
  std::string text;
  for (const std::size_t index : unit.blocks) {
    const FlatBlock& block = model_.blocks()[index];
    for (const std::string& line : block.comments) text += "  # " + line + "\n";
    for (const auto& [name, node] : block.made) {
      yaml::Node one;
      add(one, name, resolved(node));
      text += indented(yaml::yaml_text(one));
    }
  }
  return text;
}

std::string UnitTexts::comments_text(const Unit& unit) const {
  std::string text;
  std::vector<const Instance*> open{unit.instance};
  while (!open.empty()) {
    const Instance* in = open.back();
    open.pop_back();
    for (const std::string& annotation : in->system->annotations) {
      const std::string place = in->path.empty() ? "" : in->path.substr(0, in->path.size() - 1) + ": ";
      text += "# " + place + annotation.substr(0, 1000) + "\n";
    }
    for (const Block& block : in->system->blocks) {
      const auto child = in->children.find(&block);
      if (child != in->children.end() && child->second->unit == &unit) open.push_back(child->second.get());
    }
  }
  return text;
}

yaml::Node UnitTexts::parameters(const Unit& unit, Purpose purpose) const {
  yaml::Node node;
  const Workspace& workspace = model_.workspace();
  const std::set<std::string> names = unit.parent ? unit.variables : workspace.with_read(unit.variables);
  for (const std::string& name : names) {
    const Workspace::Variable& variable = workspace.variable(name);
    Value value = variable.value;
    if (unit.parent)
      for (Cell& cell : value.cells) cell = Cell{std::isfinite(cell.number) ? cell.number : 1.0};
    if (unit.parent)
      add(node, variable.written,
          map_of({{"value", value_node(value)}, {"doc", word("given by the diagram")}}));
    else if (!value.is_missing)
      add(node, variable.written, value_node(value));
    else if (purpose == Purpose::check)
      add(node, variable.written, word("1"));
    else
      add(node, variable.written,
          map_of({{"doc", word(fmt::format("{} of the workspace; its value is not in the model", name))}}));
  }
  return node;
}

yaml::Node UnitTexts::ports(const Unit& unit) const {
  yaml::Node node;
  for (const std::string& name : unit.inputs)
    if (!name.empty()) add(node, name, unit.parent ? yaml::Node{} : map_of({{"default", word("0")}}));
  for (const auto& [name, source] : unit.tags) add(node, name, yaml::Node{});
  return node;
}

void UnitTexts::add_outputs(yaml::Node& root, const Unit& unit) const {
  yaml::Node node;
  for (const auto& [port, output] : unit.outputs) {
    const auto& [name, source] = output;
    const yaml::Node signal = word(model_.resolved(source));
    const auto rest = unit.rests.find(port);
    const bool has_safe =
        unit.resets_outputs && rest != unit.rests.end() && rest->second.initial->number() != 0.0;
    add(node, name,
        has_safe ? map_of({{"signal", signal}, {"safe", value_node(*rest->second.initial)}}) : signal);
  }
  if (!node.entries.empty()) add(root, "outputs", std::move(node));
}

yaml::Node UnitTexts::head_node(const Unit& unit, Purpose purpose) const {
  yaml::Node root;
  add(root, "stepwire", word("1"));
  add(root, "title", word(on_one_line(unit.title).empty() ? "model" : on_one_line(unit.title)));
  if (!unit.parent) {
    add(root, "step", word(fmt::format("{} s", head_.step)));
    add(root, "stop", word(fmt::format("{} s", head_.stop)));
    if (collected_.has_states && head_.solver.kind != yaml::Node::Kind::empty)
      add(root, "solver", head_.solver);
    if (head_.locates_events && collected_.has_states) add(root, "events", word("locate"));
    if (solves_loops) add(root, "algebraic_loops", word("solve"));
    std::string stop;
    for (const std::string& one : collected_.stops)
      stop += (stop.empty() ? "" : " || ") + model_.resolved(one);
    if (!stop.empty()) add(root, "stop_when", word(stop));
  }
  yaml::Node of_unit = parameters(unit, purpose), inputs = ports(unit);
  if (!of_unit.entries.empty()) add(root, "parameters", std::move(of_unit));
  if (!inputs.entries.empty()) add(root, "inputs", std::move(inputs));
  add_outputs(root, unit);
  return root;
}

/// Returns the name of a recorded signal as a diagram outside sees it; empty for a constant.
std::string UnitTexts::record_name(const Collected::Recorded& one) const {
  const std::string source = model_.resolved(one.source);
  if (source == "0" || std::isdigit(static_cast<unsigned char>(source[0])) != 0) return "";
  std::string prefix;
  for (const Unit* unit = one.unit; unit->parent; unit = unit->parent) prefix = unit->name + "." + prefix;
  return prefix + source;
}

void UnitTexts::add_record(yaml::Node& root) const {
  std::vector<yaml::Node> items;
  std::set<std::string> seen;
  bool has_names = false;
  for (const Collected::Recorded& one : collected_.recorded) {
    const std::string source = record_name(one);
    if (source.empty() || !seen.insert(one.name.empty() ? source : one.name + "=" + source).second) continue;
    has_names = has_names || !one.name.empty();
    items.push_back(one.name.empty() ? word(source) : map_of({{one.name, word(source)}}));
  }
  if (items.empty()) return add(root, "record", list_of({word("all")}));
  yaml::Node list = list_of(std::move(items));
  add(root, "record", has_names ? map_of({{"signals", std::move(list)}}) : std::move(list));
}

/// Adds a figure of the first scopes whose signals are numbers.
void UnitTexts::add_figure(yaml::Node& root) const {
  std::vector<std::pair<std::string, std::vector<yaml::Node>>> panels;
  for (const Collected::Recorded& one : collected_.recorded) {
    const std::string source = record_name(one);
    if (one.scope.empty() || source.empty()) continue;
    if (panels.empty() || panels.back().first != one.scope)
      panels.emplace_back(one.scope, std::vector<yaml::Node>());
    panels.back().second.push_back(word(source));
  }
  if (panels.size() > 4) panels.resize(4);
  std::vector<yaml::Node> nodes;
  for (auto& [scope, signals] : panels)
    nodes.push_back(map_of({{"plot", word("lines")},
                            {"title", word(scope)},
                            {"x", word("time in s")},
                            {"y", list_of(std::move(signals))}}));
  if (nodes.size() == 1) return add(root, "figure", nodes[0]);
  if (!nodes.empty()) add(root, "figure", map_of({{"panels", list_of(std::move(nodes))}}));
}

std::string UnitTexts::text(const Unit& unit, Purpose purpose) const {
  std::string text = yaml::yaml_text(head_node(unit, purpose)) + comments_text(unit);
  const std::string blocks = blocks_text(unit);
  if (!blocks.empty()) text += "blocks:\n" + blocks;
  if (unit.parent) return text;
  yaml::Node tail;
  add_record(tail);
  if (has_figure) add_figure(tail);
  return text + yaml::yaml_text(tail);
}

}  // namespace stepwire::simulink
