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
  GraphWriter(const Diagram& diagram, const Outline& outline, const GraphOptions& options)
      : diagram_(diagram), options_(options), above_(scope_prefix(outline).size()) {
    for (const RecordRequest& request : diagram.records)
      for (const RecordedSignal& recorded : request.signals) add_recorded(recorded.signal);
    for (const DiagramOutput& output : diagram.outputs) add_recorded(output.signal);
  }

  /// `outputs` are those of the file itself that are drawn.
  Json graph(const Outline& outline, const std::vector<std::string>& inputs, const std::vector<int>& outputs,
             int depth) const {
    const Shown shown = shown_outputs(outline, outputs);
    Json own_inputs = Json::list(), own_outputs = Json::list(), nodes = Json::list(), wires = Json::list();
    for (const std::string& input : inputs) own_inputs.push(port(input, input));
    for (std::size_t i = 0; i < outline.children.size(); ++i) {
      nodes.push(node(outline, i, shown[i], depth));
      add_wires(outline, outline.children[i], wires);
    }
    for (const int output : outputs) {
      const auto index = static_cast<std::size_t>(output);
      const std::string& name = outline.outputs[index];
      own_outputs.push(port(name, name));
      wires.push(wire(outline, {outline.output_sources[index], {}}, end("", name)));
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

  bool is_recorded(const Outline& outline, const OutlineSource& source) const {
    const auto signal = outline.signal(source);
    return signal && recorded_.contains({signal->block, signal->output});
  }

  Shown shown_outputs(const Outline& outline, const std::vector<int>& own) const {
    std::set<std::pair<int, int>> used;
    for (const OutlineChild& child : outline.children)
      for (const OutlineInput& input : child.inputs)
        for (const OutlineFeed& feed : input.feeds)
          if (feed.source) used.insert({feed.source->child, feed.source->port});
    for (const int output : own)
      if (const auto& source = outline.output_sources[static_cast<std::size_t>(output)])
        used.insert({source->child, source->port});
    Shown shown;
    for (int child = 0; child < static_cast<int>(outline.children.size()); ++child) {
      const int count = static_cast<int>(outline.children[static_cast<std::size_t>(child)].outputs.size());
      std::vector<int> some, all;
      for (int i = 0; i < count; ++i) {
        all.push_back(i);
        if (used.contains({child, i}) || is_recorded(outline, {child, i})) some.push_back(i);
      }
      shown.push_back(some.empty() ? std::move(all) : std::move(some));
    }
    return shown;
  }

  const std::string& scope_prefix(const Outline& outline) const {
    return diagram_.scopes[static_cast<std::size_t>(outline.scope)].prefix;
  }

  /// What names of a file's blocks begin with, seen from the file that is drawn.
  std::string prefix(const Outline& outline) const { return scope_prefix(outline).substr(above_); }

  static Json port(const std::string& name, const std::string& label) {
    Json port = Json::object().set("port", name);
    if (!label.empty()) port.set("label", label);
    return port;
  }

  static Json end(const std::string& node, const std::string& port) {
    return Json::object().set("node", node).set("port", port);
  }

  /// "u" for an input, "u.1" for the first of a list.
  static std::string input_name(const OutlineInput& input, std::size_t feed) {
    return input.feeds.size() == 1 ? input.name : input.name + "." + std::to_string(feed + 1);
  }

  /// Are the names of these ports worth being drawn? Not of the only port, nor u or y alone.
  static bool are_telling(const std::vector<std::string>& names, std::size_t declared) {
    return declared > 1 && !(names.size() == 1 && (names.front() == "u" || names.front() == "y"));
  }

  Json node(const Outline& outline, std::size_t index, const std::vector<int>& shown, int depth) const {
    const OutlineChild& child = outline.children[index];
    const std::string id = prefix(outline) + child.name;
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
      if (is_recorded(outline, {static_cast<int>(index), output})) drawn.set("recorded", true);
      outputs.push(std::move(drawn));
    }
    return node.set("inputs", inputs_of(child)).set("outputs", std::move(outputs));
  }

  Json inputs_of(const OutlineChild& child) const {
    std::vector<std::string> names;
    for (const OutlineInput& input : child.inputs) names.push_back(input.name);
    const bool labelled = child.part || are_telling(names, block_of(child).type().inputs.size());
    const std::string signs = child.part ? "" : signs_of(block_of(child));
    const bool has_signs = !child.part && !block_of(child).type().symbol.signs.empty();
    Json inputs = Json::list();
    for (const OutlineInput& input : child.inputs)
      for (std::size_t i = 0; i < input.feeds.size(); ++i) {
        Json drawn = port(input_name(input, i), labelled ? input.name : "");
        if (has_signs) drawn.set("sign", std::string(1, i < signs.size() ? signs[i] : '+'));
        inputs.push(std::move(drawn));
      }
    return inputs;
  }

  const DiagramBlock& block_of(const OutlineChild& child) const {
    return diagram_.blocks[static_cast<std::size_t>(child.block)];
  }

  void add_block(Json& node, const OutlineChild& child) const {
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

  void add_part(Json& node, const OutlineChild& child, const std::string& id, const std::vector<int>& shown,
                int depth) const {
    const std::string& file = diagram_.scopes[static_cast<std::size_t>(child.part->scope)].file;
    node.set("type", std::filesystem::path(file).stem().string()).set("part", true).set("outline", "box");
    node.set("lines", Json::list());
    if (!is_open(id, depth)) return;
    std::vector<std::string> inputs;
    for (const OutlineInput& input : child.inputs) inputs.push_back(input.name);
    node.set("graph", graph(*child.part, inputs, shown, depth + 1));
  }

  void add_wires(const Outline& outline, const OutlineChild& child, Json& wires) const {
    for (const OutlineInput& input : child.inputs)
      for (std::size_t i = 0; i < input.feeds.size(); ++i)
        wires.push(wire(outline, input.feeds[i], end(prefix(outline) + child.name, input_name(input, i))));
  }

  Json wire(const Outline& outline, const OutlineFeed& feed, Json to) const {
    Json wire = Json::object();
    if (!feed.source)
      return wire.set("from", Json::object().set("constant", feed.constant)).set("to", std::move(to));
    const auto port = static_cast<std::size_t>(feed.source->port);
    if (feed.source->child < 0) {
      wire.set("from", end("", outline.inputs[port]));
    } else {
      const OutlineChild& child = outline.children[static_cast<std::size_t>(feed.source->child)];
      wire.set("from", end(prefix(outline) + child.name, child.outputs[port]));
    }
    wire.set("to", std::move(to));
    const std::string unit = options_.units ? unit_of(outline, *feed.source) : "";
    return unit.empty() ? wire : wire.set("unit", unit);
  }

  std::string unit_of(const Outline& outline, const OutlineSource& source) const {
    const auto signal = outline.signal(source);
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

Json graph_of(const Diagram& diagram, const Outline& outline, const GraphOptions& options) {
  std::vector<int> outputs;
  for (std::size_t i = 0; i < outline.outputs.size(); ++i) outputs.push_back(static_cast<int>(i));
  return GraphWriter(diagram, outline, options).graph(outline, outline.inputs, outputs, 0);
}

}  // namespace stepwire
