#include "engine/draw/graph.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "engine/draw/symbol_text.hpp"

namespace stepwire {

namespace {

const char* outline_name(Symbol::Outline outline) {
  switch (outline) {
    case Symbol::Outline::triangle:
      return "triangle";
    case Symbol::Outline::circle:
      return "circle";
    case Symbol::Outline::bar:
      return "bar";
    default:
      return "box";
  }
}

/// A sign for each input that a parameter such as "+-" holds.
std::string signs_of(const DiagramBlock& block) {
  const ParameterSpec* parameter = block.type().parameter(block.type().symbol.signs);
  if (!parameter) return {};
  const Value value = parameter->get(block.block.get());
  return value.text() ? *value.text() : "";
}

class GraphWriter {
 public:
  GraphWriter(const Diagram& diagram, const Sheet& sheet, const GraphOptions& options)
      : diagram_(diagram), options_(options), above_(scope_prefix(sheet).size()) {
    for (const RecordRequest& request : diagram.records)
      for (const RecordedSignal& recorded : request.signals) add_recorded(recorded.signal);
    for (const DiagramOutput& output : diagram.outputs) add_recorded(output.signal);
  }

  /// `outputs` are those of the file itself that are drawn.
  Json graph(const Sheet& sheet, const std::vector<std::string>& inputs, const std::vector<int>& outputs,
             int depth) const {
    const Shown shown = shown_outputs(sheet, outputs);
    Json own_inputs = Json::list(), own_outputs = Json::list(), nodes = Json::list(), wires = Json::list();
    for (const std::string& input : inputs) own_inputs.push(port(input, input));
    for (std::size_t i = 0; i < sheet.children.size(); ++i) {
      nodes.push(node(sheet, i, shown[i], depth));
      add_wires(sheet, sheet.children[i], wires);
    }
    for (const int output : outputs) {
      const auto index = static_cast<std::size_t>(output);
      const std::string& name = sheet.outputs[index];
      own_outputs.push(port(name, name));
      wires.push(wire(sheet, {sheet.output_sources[index], {}}, end("", name)));
    }
    return Json::object()
        .set("inputs", std::move(own_inputs))
        .set("outputs", std::move(own_outputs))
        .set("nodes", std::move(nodes))
        .set("wires", std::move(wires));
  }

 private:
  /// For each child the outputs that are drawn.
  using Shown = std::vector<std::vector<int>>;

  void add_recorded(const SignalRef& signal) { recorded_.insert({signal.block, signal.output}); }

  bool is_recorded(const Sheet& sheet, const SheetSource& source) const {
    const auto signal = sheet.signal(source);
    return signal && recorded_.contains({signal->block, signal->output});
  }

  Shown shown_outputs(const Sheet& sheet, const std::vector<int>& own) const {
    std::set<std::pair<int, int>> used;
    for (const SheetChild& child : sheet.children)
      for (const SheetInput& input : child.inputs)
        for (const SheetFeed& feed : input.feeds)
          if (feed.source) used.insert({feed.source->child, feed.source->port});
    for (const int output : own)
      if (const auto& source = sheet.output_sources[static_cast<std::size_t>(output)])
        used.insert({source->child, source->port});
    Shown shown;
    for (int child = 0; child < static_cast<int>(sheet.children.size()); ++child) {
      const int count = static_cast<int>(sheet.children[static_cast<std::size_t>(child)].outputs.size());
      std::vector<int> some, all;
      for (int i = 0; i < count; ++i) {
        all.push_back(i);
        if (used.contains({child, i}) || is_recorded(sheet, {child, i})) some.push_back(i);
      }
      shown.push_back(some.empty() ? std::move(all) : std::move(some));
    }
    return shown;
  }

  const std::string& scope_prefix(const Sheet& sheet) const {
    return diagram_.scopes[static_cast<std::size_t>(sheet.scope)].prefix;
  }

  /// What names of a file's blocks begin with, seen from the file that is drawn.
  std::string prefix(const Sheet& sheet) const { return scope_prefix(sheet).substr(above_); }

  static Json port(const std::string& name, const std::string& label) {
    Json port = Json::object().set("port", name);
    if (!label.empty()) port.set("label", label);
    return port;
  }

  static Json end(const std::string& node, const std::string& port) {
    return Json::object().set("node", node).set("port", port);
  }

  /// "u" for an input, "u.1" for the first of a list.
  static std::string input_name(const SheetInput& input, std::size_t feed) {
    return input.feeds.size() == 1 ? input.name : input.name + "." + std::to_string(feed + 1);
  }

  /// Are the names of these ports worth being drawn? Not of the only port, nor u or y alone.
  static bool are_telling(const std::vector<std::string>& names, std::size_t declared) {
    return declared > 1 && !(names.size() == 1 && (names.front() == "u" || names.front() == "y"));
  }

  Json node(const Sheet& sheet, std::size_t index, const std::vector<int>& shown, int depth) const {
    const SheetChild& child = sheet.children[index];
    const std::string id = prefix(sheet) + child.name;
    Json node = Json::object().set("id", id).set("name", child.name);
    if (child.part)
      add_part(node, child, id, shown, depth);
    else
      add_block(node, child);
    std::vector<std::string> names;
    for (const int output : shown) names.push_back(child.outputs[static_cast<std::size_t>(output)]);
    const bool labelled = child.part || are_telling(names, block_of(child).type().outputs.size());
    Json outputs = Json::list();
    for (const int output : shown) {
      const std::string& name = child.outputs[static_cast<std::size_t>(output)];
      Json drawn = port(name, labelled ? name : "");
      if (is_recorded(sheet, {static_cast<int>(index), output})) drawn.set("recorded", true);
      outputs.push(std::move(drawn));
    }
    return node.set("inputs", inputs_of(child)).set("outputs", std::move(outputs));
  }

  Json inputs_of(const SheetChild& child) const {
    std::vector<std::string> names;
    for (const SheetInput& input : child.inputs) names.push_back(input.name);
    const bool labelled = child.part || are_telling(names, block_of(child).type().inputs.size());
    const std::string signs = child.part ? "" : signs_of(block_of(child));
    const bool has_signs = !child.part && !block_of(child).type().symbol.signs.empty();
    Json inputs = Json::list();
    for (const SheetInput& input : child.inputs)
      for (std::size_t i = 0; i < input.feeds.size(); ++i) {
        Json drawn = port(input_name(input, i), labelled ? input.name : "");
        if (has_signs) drawn.set("sign", std::string(1, i < signs.size() ? signs[i] : '+'));
        inputs.push(std::move(drawn));
      }
    return inputs;
  }

  const DiagramBlock& block_of(const SheetChild& child) const {
    return diagram_.blocks[static_cast<std::size_t>(child.block)];
  }

  void add_block(Json& node, const SheetChild& child) const {
    const DiagramBlock& block = block_of(child);
    const Symbol& symbol = block.type().symbol;
    const SymbolText text = symbol_text(block, *child.written);
    node.set("type", block.type().name).set("outline", outline_name(symbol.outline));
    node.set("lines", Json::list_of(text.lines));
    if (text.fraction) node.set("fraction", true);
    if (!symbol.curve.empty()) node.set("curve", symbol.curve);
    if (symbol.axes) node.set("axes", true);
    if (block.type().has_continuous_state()) node.set("state", true);
  }

  bool is_open(const std::string& id, int depth) const {
    return depth < options_.depth ||
           std::any_of(options_.open.begin(), options_.open.end(),
                       [&](const auto& open) { return open == id || open.starts_with(id + "."); });
  }

  void add_part(Json& node, const SheetChild& child, const std::string& id, const std::vector<int>& shown,
                int depth) const {
    const std::string& file = diagram_.scopes[static_cast<std::size_t>(child.part->scope)].file;
    node.set("type", std::filesystem::path(file).stem().string()).set("part", true).set("outline", "box");
    node.set("lines", Json::list());
    if (!is_open(id, depth)) return;
    std::vector<std::string> inputs;
    for (const SheetInput& input : child.inputs) inputs.push_back(input.name);
    node.set("graph", graph(*child.part, inputs, shown, depth + 1));
  }

  void add_wires(const Sheet& sheet, const SheetChild& child, Json& wires) const {
    for (const SheetInput& input : child.inputs)
      for (std::size_t i = 0; i < input.feeds.size(); ++i)
        wires.push(wire(sheet, input.feeds[i], end(prefix(sheet) + child.name, input_name(input, i))));
  }

  Json wire(const Sheet& sheet, const SheetFeed& feed, Json to) const {
    Json wire = Json::object();
    if (!feed.source)
      return wire.set("from", Json::object().set("constant", feed.constant)).set("to", std::move(to));
    const auto port = static_cast<std::size_t>(feed.source->port);
    if (feed.source->child < 0) {
      wire.set("from", end("", sheet.inputs[port]));
    } else {
      const SheetChild& child = sheet.children[static_cast<std::size_t>(feed.source->child)];
      wire.set("from", end(prefix(sheet) + child.name, child.outputs[port]));
    }
    wire.set("to", std::move(to));
    const std::string unit = options_.units ? unit_of(sheet, *feed.source) : "";
    return unit.empty() ? wire : wire.set("unit", unit);
  }

  std::string unit_of(const Sheet& sheet, const SheetSource& source) const {
    const auto signal = sheet.signal(source);
    if (!signal) return {};
    const auto block = static_cast<std::size_t>(signal->block),
               output = static_cast<std::size_t>(signal->output);
    if (block >= diagram_.output_dimensions.size()) return {};
    const auto& dimension = diagram_.output_dimensions[block][output];
    return dimension ? si_name(*dimension) : "";
  }

  const Diagram& diagram_;
  const GraphOptions& options_;
  std::size_t above_;  ///< letters that lie above the file that is drawn
  std::set<std::pair<int, int>> recorded_;
};

}  // namespace

Json graph_of(const Diagram& diagram, const Sheet& sheet, const GraphOptions& options) {
  std::vector<int> outputs;
  for (std::size_t i = 0; i < sheet.outputs.size(); ++i) outputs.push_back(static_cast<int>(i));
  return GraphWriter(diagram, sheet, options).graph(sheet, sheet.inputs, outputs, 0);
}

}  // namespace stepwire
