#include "engine/view/drawing/graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "engine/model/diagram/diagram.hpp"
#include "engine/view/drawing/chart_graph.hpp"
#include "engine/view/drawing/symbol_text.hpp"

namespace stepwire::drawing {

using json::Json;

namespace {

/// Selection of the drawn blocks and outputs: all but hidden blocks, and the outputs of each child that have
/// a sink.
class Selection {
 public:
  /// Drawn outputs of a child; an empty list if it is hidden.
  struct Shown {
    bool hidden = false;
    std::vector<int> outputs;
  };

  /// Connection of an input.
  struct Feed {
    const ReferenceInput* input = nullptr;
    std::size_t index = 0;  ///< in its list
  };

  /// `hierarchy` is the drawn file.
  Selection(const diagram::Diagram& diagram, const Hierarchy& hierarchy, const GraphOptions& options);

  /// Returns the full name of a block, relative to the drawn file.
  std::string name_in(const Hierarchy& hierarchy, const std::string& name) const;
  /// Returns the drawn outputs of each child of a file; `own` are the drawn outputs of the file itself.
  std::vector<Shown> shown(const Hierarchy& hierarchy, const std::vector<int>& own) const;
  /// Returns the drawn outputs of the file itself.
  std::vector<int> own_outputs(const Hierarchy& hierarchy) const;
  /// Returns the drawn connections of a child, without hidden sources and without inputs of an opened part
  /// that only hidden blocks use.
  std::vector<Feed> feeds(const Hierarchy& hierarchy, const BlockReference& child, int depth) const;
  bool is_recorded(const Hierarchy& hierarchy, const WireSource& source) const;
  bool is_open(const std::string& name, int depth) const;

 private:
  bool hides(const std::string& name) const;
  /// True if this signal is hidden, by itself or with its block.
  bool hides(const Hierarchy& hierarchy, const WireSource& source) const;
  bool feeds_hidden_only(const Hierarchy& part, const std::string& input) const;
  bool hides_child(const Hierarchy& hierarchy, const BlockReference& child) const {
    return hides(name_in(hierarchy, child.name));
  }
  std::vector<int> outputs_of(const Hierarchy& hierarchy, int child,
                              const std::set<std::pair<int, int>>& used) const;
  void add_recorded(const diagram::SignalRef& signal) { recorded_.insert({signal.block, signal.output}); }
  const std::string& scope_prefix(const Hierarchy& hierarchy) const {
    return diagram_.scopes[static_cast<std::size_t>(hierarchy.scope)].prefix;
  }

  const diagram::Diagram& diagram_;
  const GraphOptions& options_;
  std::size_t above_;  ///< length of the prefix above the drawn file
  std::set<std::pair<int, int>> recorded_;
};

Selection::Selection(const diagram::Diagram& diagram, const Hierarchy& hierarchy, const GraphOptions& options)
    : diagram_(diagram), options_(options), above_(scope_prefix(hierarchy).size()) {
  for (const diagram::RecordRequest& request : diagram.records)
    for (const diagram::RecordedSignal& recorded : request.signals) add_recorded(recorded.signal);
  for (const diagram::DiagramOutput& output : diagram.outputs) add_recorded(output.signal);
}

std::string Selection::name_in(const Hierarchy& hierarchy, const std::string& name) const {
  return scope_prefix(hierarchy).substr(above_) + name;
}

bool Selection::hides(const std::string& name) const {
  return std::ranges::any_of(options_.hide,
                             [&](const auto& pattern) { return follows_pattern(name, pattern); });
}

bool Selection::hides(const Hierarchy& hierarchy, const WireSource& source) const {
  const auto port = static_cast<std::size_t>(source.port);
  if (source.child < 0) {
    if (!hierarchy.parent) return false;
    for (const ReferenceInput& input :
         hierarchy.parent->children[static_cast<std::size_t>(hierarchy.place)].inputs)
      if (input.name == hierarchy.inputs[port])
        return input.feeds.front().source && hides(*hierarchy.parent, *input.feeds.front().source);
    return false;
  }
  const BlockReference& from = hierarchy.children[static_cast<std::size_t>(source.child)];
  const std::string name = name_in(hierarchy, from.name);
  if (hides(name) || hides(name + "." + from.outputs[port])) return true;
  const auto inner =
      from.part && !from.is_active(source.port) ? from.part->output_sources[port] : std::nullopt;
  return inner && inner->child >= 0 && hides(*from.part, *inner);
}

bool Selection::is_recorded(const Hierarchy& hierarchy, const WireSource& source) const {
  const auto signal = hierarchy.signal(source);
  return signal && recorded_.contains({signal->block, signal->output});
}

bool Selection::is_open(const std::string& name, int depth) const {
  return depth < options_.depth || std::ranges::any_of(options_.open, [&](const auto& open) {
           return open == name || open.starts_with(name + ".");
         });
}

bool Selection::feeds_hidden_only(const Hierarchy& part, const std::string& input) const {
  bool feeds_any = false;
  const auto is_source = [&](const std::optional<WireSource>& source) {
    return source && source->child < 0 && part.inputs[static_cast<std::size_t>(source->port)] == input;
  };
  const auto is_input = [&](const WireFeed& feed) { return is_source(feed.source); };
  if (std::ranges::any_of(part.output_sources, is_source)) return false;
  for (const BlockReference& child : part.children)
    for (const ReferenceInput& one : child.inputs) {
      if (std::ranges::none_of(one.feeds, is_input)) continue;
      if (!hides_child(part, child)) return false;
      feeds_any = true;
    }
  return feeds_any;
}

std::vector<Selection::Feed> Selection::feeds(const Hierarchy& hierarchy, const BlockReference& child,
                                              int depth) const {
  const bool opened = child.part && is_open(name_in(hierarchy, child.name), depth);
  std::vector<Feed> found;
  for (const ReferenceInput& input : child.inputs) {
    if (opened && feeds_hidden_only(*child.part, input.name)) continue;
    for (std::size_t i = 0; i < input.feeds.size(); ++i)
      if (!input.feeds[i].source || !hides(hierarchy, *input.feeds[i].source)) found.push_back({&input, i});
  }
  return found;
}

std::vector<int> Selection::own_outputs(const Hierarchy& hierarchy) const {
  std::vector<int> found;
  for (int i = 0; i < static_cast<int>(hierarchy.outputs.size()); ++i) {
    const auto& source = hierarchy.output_sources[static_cast<std::size_t>(i)];
    const bool hidden = hides(name_in(hierarchy, hierarchy.outputs[static_cast<std::size_t>(i)]));
    if (!hidden && !(source && hides(hierarchy, *source))) found.push_back(i);
  }
  return found;
}

/// Returns the outputs with a visible sink. If none has one, returns all outputs of its own that are not
/// hidden.
std::vector<int> Selection::outputs_of(const Hierarchy& hierarchy, int child,
                                       const std::set<std::pair<int, int>>& used) const {
  const BlockReference& from = hierarchy.children[static_cast<std::size_t>(child)];
  const int count = static_cast<int>(from.outputs.size());
  std::vector<int> some, all;
  for (int i = 0; i < count; ++i) {
    if (hides(hierarchy, WireSource{child, i})) continue;
    if (i < static_cast<int>(from.own_outputs)) all.push_back(i);
    if (used.contains({child, i}) || is_recorded(hierarchy, {child, i})) some.push_back(i);
  }
  return some.empty() ? all : some;
}

std::vector<Selection::Shown> Selection::shown(const Hierarchy& hierarchy,
                                               const std::vector<int>& own) const {
  std::set<std::pair<int, int>> used;
  for (const BlockReference& child : hierarchy.children)
    for (const ReferenceInput& input : child.inputs)
      for (const WireFeed& feed : input.feeds)
        if (feed.source && !hides_child(hierarchy, child))
          used.insert({feed.source->child, feed.source->port});
  for (const int output : own)
    if (const auto& source = hierarchy.output_sources[static_cast<std::size_t>(output)])
      used.insert({source->child, source->port});
  std::vector<Shown> shown;
  for (int child = 0; child < static_cast<int>(hierarchy.children.size()); ++child) {
    const bool hidden = hides_child(hierarchy, hierarchy.children[static_cast<std::size_t>(child)]);
    shown.push_back({hidden, hidden ? std::vector<int>{} : outputs_of(hierarchy, child, used)});
  }
  return shown;
}

/// Returns the name of an outline in draw.mjs.
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

/// Returns the signs of the inputs in a parameter such as "+-".
inline std::string signs_of(const diagram::DiagramBlock& block) {
  const ParameterSpec* parameter = block.type().parameter(block.type().symbol.signs);
  if (!parameter) return {};
  const Value value = parameter->get(block.block.get());
  return value.text() ? *value.text() : "";
}

constexpr std::size_t max_drawn = 2000;  // a layout of more takes minutes

class GraphWriter {
 public:
  GraphWriter(const diagram::Diagram& diagram, const Hierarchy& hierarchy, const GraphOptions& options)
      : diagram_(diagram), options_(options), selection_(diagram, hierarchy, options) {}

  /// Returns the complete graph, with its groups of blocks.
  Json whole(const Hierarchy& hierarchy) {
    signals_.insert(signals_.end(), hierarchy.inputs.begin(), hierarchy.inputs.end());
    Json drawn = graph(hierarchy, hierarchy.inputs, selection_.own_outputs(hierarchy), 0);
    if (options_.groups.empty()) return drawn;
    Json groups = Json::list();
    for (const NodeGroup& group : options_.groups)
      groups.push(Json::object().set("name", group.name).set("members", Json::list_of(group.members)));
    return drawn.set("groups", std::move(groups));
  }

  const std::vector<std::string>& signals() const { return signals_; }

 private:
  void require_few(const Hierarchy& hierarchy) {
    drawn_ += hierarchy.children.size();
    if (drawn_ > max_drawn)
      throw yaml::Error(
          yaml::Fault{{diagram_.file, {}},
                      "",
                      fmt::format("more than {} blocks would be drawn; open fewer parts", max_drawn),
                      {}});
  }

  /// `outputs` are the drawn ones of the file itself.
  Json graph(const Hierarchy& hierarchy, const std::vector<std::string>& inputs,
             const std::vector<int>& outputs, int depth) {
    const auto shown = selection_.shown(hierarchy, outputs);
    Json own_inputs = Json::list(), own_outputs = Json::list(), nodes = Json::list(), wires = Json::list();
    for (const std::string& input : inputs) own_inputs.push(marked(port(input, input), hierarchy, input));
    require_few(hierarchy);
    for (std::size_t i = 0; i < hierarchy.children.size(); ++i) {
      if (shown[i].hidden) continue;
      nodes.push(node(hierarchy, i, shown[i].outputs, depth));
      add_wires(hierarchy, hierarchy.children[i], depth, wires);
    }
    for (const int output : outputs) {
      const auto index = static_cast<std::size_t>(output);
      const std::string& name = hierarchy.outputs[index];
      own_outputs.push(port(name, name));
      wires.push(wire(hierarchy, hierarchy.output_feeds[index], end("", name)));
    }
    return Json::object()
        .set("inputs", std::move(own_inputs))
        .set("outputs", std::move(own_outputs))
        .set("nodes", std::move(nodes))
        .set("wires", std::move(wires));
  }

  /// Returns a port of the file itself, with the text on its wire. A part has this text outside.
  Json marked(Json port, const Hierarchy& hierarchy, const std::string& name) const {
    const auto label = hierarchy.parent ? options_.labels.end() : options_.labels.find(name);
    if (label != options_.labels.end()) port.set("mark", label->second);
    return port;
  }

  static Json port(const std::string& name, const std::string& label) {
    Json port = Json::object().set("port", name);
    if (!label.empty()) port.set("label", label);
    return port;
  }

  static Json end(const std::string& node, const std::string& port) {
    return Json::object().set("node", node).set("port", port);
  }

  /// Returns "u" for an input, "u.1" for the first of a list.
  static std::string input_name(const ReferenceInput& input, std::size_t feed) {
    return input.feeds.size() == 1 ? input.name : input.name + "." + std::to_string(feed + 1);
  }

  /// True if the names of these ports are drawn: not for a single port, nor for a single u or y.
  static bool are_telling(const std::vector<std::string>& names, std::size_t declared) {
    return declared > 1 && !(names.size() == 1 && (names.front() == "u" || names.front() == "y"));
  }

  Json node(const Hierarchy& hierarchy, std::size_t index, const std::vector<int>& shown, int depth) {
    const BlockReference& child = hierarchy.children[index];
    const std::string id = selection_.name_in(hierarchy, child.name);
    const auto other = options_.names.find(id);
    Json node = Json::object().set("id", id);
    node.set("name", other == options_.names.end() ? child.name : other->second);
    if (child.part)
      add_part(node, hierarchy, child, id, shown, depth);
    else if (child.is_bus())
      node.set("type", "bus").set("outline", "bar").set("lines", Json::list());
    else
      add_block(node, child);
    Json inputs = inputs_of(hierarchy, child, depth), outputs = outputs_of(hierarchy, index, id, shown);
    if (child.block >= 0 && selection_.is_open(id, depth)) add_chart(node, child, id, inputs, outputs);
    return node.set("inputs", std::move(inputs)).set("outputs", std::move(outputs));
  }

  Json outputs_of(const Hierarchy& hierarchy, std::size_t index, const std::string& id,
                  const std::vector<int>& shown) {
    const BlockReference& child = hierarchy.children[index];
    std::vector<std::string> names;
    for (const int output : shown) names.push_back(child.outputs[static_cast<std::size_t>(output)]);
    const bool labelled =
        child.part || (child.block >= 0 && are_telling(names, block_of(child).type().outputs.size()));
    Json outputs = Json::list();
    for (const int output : shown) {
      const std::string& name = child.outputs[static_cast<std::size_t>(output)];
      Json drawn = port(name, labelled ? name : "");
      if (selection_.is_recorded(hierarchy, {static_cast<int>(index), output})) drawn.set("recorded", true);
      if (child.is_active(output)) drawn.set("guard", true);
      if (const std::string* label = label_of(id, name, output == 0 && child.own_outputs == 1))
        drawn.set("mark", *label);
      signals_.push_back(id + "." + name);
      if (output == 0 && child.own_outputs == 1) signals_.push_back(id);
      outputs.push(std::move(drawn));
    }
    return outputs;
  }

  /// Returns the text on the wire of a block's output, by the output's name. If it is the block's only one
  /// (`alone`), the block's name is valid too. Returns nullptr without a text.
  const std::string* label_of(const std::string& id, const std::string& output, bool alone) const {
    auto found = options_.labels.find(id + "." + output);
    if (found == options_.labels.end() && alone) found = options_.labels.find(id);
    return found == options_.labels.end() ? nullptr : &found->second;
  }

  Json inputs_of(const Hierarchy& hierarchy, const BlockReference& child, int depth) const {
    std::vector<std::string> names;
    for (const ReferenceInput& input : child.inputs)
      if (!input.is_condition) names.push_back(input.name);
    const bool is_block = child.block >= 0;
    const bool labelled = !is_block || are_telling(names, block_of(child).type().inputs.size());
    const std::string signs = is_block ? signs_of(block_of(child)) : "";
    const bool has_signs = is_block && !block_of(child).type().symbol.signs.empty();
    Json inputs = Json::list();
    for (const auto& [input, i] : selection_.feeds(hierarchy, child, depth)) {
      Json drawn = port(input_name(*input, i), (input->is_condition ? i == 0 : labelled) ? input->name : "");
      if (input->is_condition) drawn.set("condition", true);
      if (has_signs && !input->is_condition)
        drawn.set("sign", std::string(1, i < signs.size() ? signs[i] : '+'));
      inputs.push(std::move(drawn));
    }
    return inputs;
  }

  const diagram::DiagramBlock& block_of(const BlockReference& child) const {
    return diagram_.blocks[static_cast<std::size_t>(child.block)];
  }

  void add_block(Json& node, const BlockReference& child) const {
    const diagram::DiagramBlock& block = block_of(child);
    const Symbol& symbol = block.type().symbol;
    const SymbolText text = symbol_text(block, *child.written);
    node.set("type", block.type().name).set("outline", outline_name(symbol.outline));
    node.set("lines", Json::list_of(text.lines));
    if (text.fraction) node.set("fraction", true);
    if (!symbol.curve.empty()) node.set("curve", symbol.curve);
    if (symbol.axes) node.set("axes", true);
    if (block.type().has_continuous_state()) node.set("state", true);
    if (const auto every = sample_time_text(block, *child.written); !every.empty()) node.set("every", every);
  }

  /// Returns the ports of a frame that lead to its content, without those of its enable and trigger.
  static Json inner_ports(const Json& ports) {
    Json inner = Json::list();
    for (const Json& port : ports.items())
      if (!port.find("condition") && !port.find("guard")) inner.push(port);
    return inner;
  }

  /// Adds the states of a block, if any, in a frame with its ports.
  void add_chart(Json& node, const BlockReference& child, const std::string& id, const Json& inputs,
                 const Json& outputs) const {
    const auto states = chart_of(block_of(child));
    if (!states) return;
    node.set("part", true).set("lines", Json::list());
    Json chart = chart_graph(*states, id);
    chart.set("inputs", inner_ports(inputs)).set("outputs", inner_ports(outputs));
    node.set("graph", std::move(chart));
  }

  void add_part(Json& node, const Hierarchy& hierarchy, const BlockReference& child, const std::string& id,
                std::vector<int> shown, int depth) {
    const std::string& file = diagram_.scopes[static_cast<std::size_t>(child.part->scope)].file;
    node.set("type", std::filesystem::path(file).stem().string()).set("part", true).set("outline", "box");
    node.set("lines", Json::list());
    if (!selection_.is_open(id, depth)) return;
    std::vector<std::string> inputs;
    for (const auto& feed : selection_.feeds(hierarchy, child, depth))
      if (!feed.input->is_condition) inputs.push_back(feed.input->name);
    std::erase_if(shown, [&](int output) { return child.is_active(output); });
    node.set("graph", graph(*child.part, inputs, shown, depth + 1));
  }

  void add_wires(const Hierarchy& hierarchy, const BlockReference& child, int depth, Json& wires) const {
    for (const auto& [input, i] : selection_.feeds(hierarchy, child, depth))
      wires.push(wire(hierarchy, input->feeds[i],
                      end(selection_.name_in(hierarchy, child.name), input_name(*input, i))));
  }

  Json wire(const Hierarchy& hierarchy, const WireFeed& feed, Json to) const {
    Json wire = Json::object();
    if (!feed.source)
      return wire.set("from", Json::object().set("constant", feed.constant)).set("to", std::move(to));
    const auto port = static_cast<std::size_t>(feed.source->port);
    if (feed.source->child < 0) {
      wire.set("from", end("", hierarchy.inputs[port]));
    } else {
      const BlockReference& child = hierarchy.children[static_cast<std::size_t>(feed.source->child)];
      wire.set("from", end(selection_.name_in(hierarchy, child.name), child.outputs[port]));
    }
    wire.set("to", std::move(to));
    if (!feed.element.empty()) wire.set("element", feed.element);
    if (feed.is_bus) return wire.set("bus", true);
    const std::string unit =
        options_.units && feed.element.find_first_not_of("0123456789.") == std::string::npos
            ? unit_of(hierarchy, *feed.source)
            : "";
    return unit.empty() ? wire : wire.set("unit", unit);
  }

  std::string unit_of(const Hierarchy& hierarchy, const WireSource& source) const {
    const auto signal = hierarchy.signal(source);
    if (!signal) return {};
    const auto block = static_cast<std::size_t>(signal->block),
               output = static_cast<std::size_t>(signal->output);
    if (block >= diagram_.output_dimensions.size()) return {};
    const auto& dimension = diagram_.output_dimensions[block][output];
    return dimension ? unit::si_name(*dimension) : "";
  }

  const diagram::Diagram& diagram_;
  const GraphOptions& options_;
  Selection selection_;
  std::vector<std::string> signals_;  ///< signals that have a place in the drawing
  std::size_t drawn_ = 0;             ///< number of blocks and parts
};

}  // namespace

Json graph_of(const diagram::Diagram& diagram, const Hierarchy& hierarchy, const GraphOptions& options) {
  return GraphWriter(diagram, hierarchy, options).whole(hierarchy);
}

std::vector<std::string> drawn_signals(const diagram::Diagram& diagram, const Hierarchy& hierarchy,
                                       const GraphOptions& options) {
  GraphWriter writer(diagram, hierarchy, options);
  writer.whole(hierarchy);
  return writer.signals();
}

bool follows_pattern(const std::string& name, const std::string& pattern) {
  // Greedy matching: only the last star needs to be extended, since another length of an earlier star cannot
  // match better.
  std::size_t at = 0, in_pattern = 0, star = std::string::npos, resumed = 0;
  while (at < name.size()) {
    if (in_pattern < pattern.size() && pattern[in_pattern] == '*') {
      star = in_pattern++;
      resumed = at;
    } else if (in_pattern < pattern.size() && pattern[in_pattern] == name[at]) {
      ++in_pattern;
      ++at;
    } else if (star != std::string::npos) {
      in_pattern = star + 1;
      at = ++resumed;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', in_pattern) == std::string::npos;
}

}  // namespace stepwire::drawing
