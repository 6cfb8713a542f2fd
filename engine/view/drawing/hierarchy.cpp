// More than 300 lines with its header: blocks, buses and conditions are found in one pass over a file and its
// parts.
#include "engine/view/drawing/hierarchy.hpp"

#include <map>
#include <set>

#include "engine/model/diagram/block_keys.hpp"
#include "engine/model/diagram/bus_fields.hpp"
#include "engine/model/diagram/element_index.hpp"
#include "engine/model/diagram/guard_keys.hpp"
#include "engine/model/diagram/guard_types.hpp"
#include "engine/model/diagram/output_names.hpp"
#include "engine/model/diagram/resolve.hpp"
#include "engine/view/drawing/symbol_text.hpp"

namespace stepwire::drawing {

namespace {

class OutlineReader {
 public:
  OutlineReader(const diagram::Diagram& diagram, diagram::Loader& loader)
      : diagram_(diagram), loader_(loader) {
    for (std::size_t i = 0; i < diagram.blocks.size(); ++i) {
      blocks_[diagram.blocks[i].name] = static_cast<int>(i);
      // Of the copies of a block for the fields of a bus, the first one is drawn.
      if (!diagram.blocks[i].copy_of.empty())
        blocks_.try_emplace(diagram.blocks[i].copy_of, static_cast<int>(i));
    }
    for (const diagram::DiagramBus& bus : diagram.buses)
      for (const auto& [field, signal] : bus.fields) bus_fields_.insert(bus.name + "." + field);
    for (std::size_t i = 1; i < diagram.scopes.size(); ++i)
      scopes_[diagram.scopes[i].prefix] = static_cast<int>(i);
  }

  std::unique_ptr<Hierarchy> read(int scope) {
    auto hierarchy = std::make_unique<Hierarchy>();
    hierarchy->scope = scope;
    const diagram::ScopeInfo& info = diagram_.scopes[static_cast<std::size_t>(scope)];
    const yaml::Node& root = loader_.document(info.file).root;
    hierarchy->inputs = keys(root, "inputs");
    hierarchy->outputs = keys(root, "outputs");
    if (const yaml::Node* blocks = root.find("blocks"))
      for (const yaml::Entry& entry : blocks->entries)
        hierarchy->children.push_back(child(entry, info.prefix));
    connect(*hierarchy, root);
    return hierarchy;
  }

 private:
  static std::vector<std::string> keys(const yaml::Node& root, const char* key) {
    std::vector<std::string> names;
    if (const yaml::Node* map = root.find(key))
      for (const yaml::Entry& entry : map->entries) names.push_back(entry.key);
    return names;
  }

  BlockReference child(const yaml::Entry& entry, const std::string& prefix) {
    BlockReference child;
    child.name = entry.key;
    child.written = &entry.value;
    if (const auto scope = scopes_.find(prefix + entry.key + "."); scope != scopes_.end()) {
      child.part = read(scope->second);
      child.outputs = child.part->outputs;
      child.own_outputs = child.outputs.size();
    } else if (!entry.value.find("block")) {
      child.outputs = {"bus"};
      return child;
    } else {
      child.block = blocks_.at(prefix + entry.key);
      for (const OutputSpec& output : type_of(child).outputs) child.outputs.push_back(output.name);
      child.own_outputs = diagram::has_one_output(type_of(child)) ? 1 : child.outputs.size();
    }
    const auto guard = blocks_.find(prefix + entry.key + ".active");
    const bool is_guard =
        guard != blocks_.end() &&
        &diagram_.blocks[static_cast<std::size_t>(guard->second)].type() == &diagram::guard_type();
    if (!is_guard) return child;
    child.guard = guard->second;
    child.outputs.push_back("active");
    return child;
  }

  const diagram::DiagramBlock& block_of(const BlockReference& child) const {
    return diagram_.blocks[static_cast<std::size_t>(child.block)];
  }
  const BlockType& type_of(const BlockReference& child) const { return block_of(child).type(); }

  void connect_inputs(const Hierarchy& hierarchy, const diagram::Scope& names, BlockReference& child) {
    if (child.part) {
      for (const std::string& input : child.part->inputs) add_input(hierarchy, names, child, input, false);
    } else if (child.is_bus()) {
      for (const diagram::BusField& field : diagram::written_fields(*child.written))
        child.inputs.push_back({field.name, {feed(hierarchy, names, *field.signal)}});
    } else {
      for (std::size_t i = 0; i < type_of(child).inputs.size(); ++i)
        if (const InputSpec& input = type_of(child).inputs[i]; !has_value_in_place(child, i))
          add_input(hierarchy, names, child, input.name, input.list);
    }
    if (child.guard >= 0)
      for (const char* key : {"enable", "trigger"}) add_condition(hierarchy, names, child, key);
  }

  /// Finds the sources of all inputs. Requires that all children are known.
  void connect(Hierarchy& hierarchy, const yaml::Node& root) {
    diagram::Scope names;
    for (const BlockReference& child : hierarchy.children) names.names[child.name];
    for (std::size_t i = 0; i < hierarchy.children.size(); ++i) {
      BlockReference& child = hierarchy.children[i];
      if (child.part) child.part->parent = &hierarchy;
      if (child.part) child.part->place = static_cast<int>(i);
      connect_inputs(hierarchy, names, child);
    }
    for (const std::string& output : hierarchy.outputs) {
      const yaml::Node& port = *root.find("outputs")->find(output);
      const std::string& signal = port.is_map() ? port.find("signal")->text : port.text;
      const auto found = source(hierarchy, names, signal);
      hierarchy.output_sources.push_back(found);
      hierarchy.output_feeds.push_back(found ? wired(hierarchy, *found, signal) : WireFeed{});
    }
  }

  /// True if the key of this input has a value, such as `initial: 2 m`, and not a signal.
  bool has_value_in_place(const BlockReference& child, std::size_t input) const {
    return block_of(child).inputs[input].empty() &&
           diagram::has_value(type_of(child), type_of(child).inputs[input].name);
  }

  void add_input(const Hierarchy& hierarchy, const diagram::Scope& names, BlockReference& child,
                 const std::string& name, bool list) {
    const yaml::Node* node = child.written->find(name);
    if (!node || diagram::is_condition(name, *node)) return;
    ReferenceInput input{name, {}};
    if (list && node->is_list()) {
      for (const yaml::Node& item : node->items) input.feeds.push_back(feed(hierarchy, names, item));
    } else if (node->is_map() && !node->find("value")) {  // a bus literal
      for (const diagram::BusField& field : diagram::written_fields(*node))
        input.feeds.push_back(feed(hierarchy, names, *field.signal));
    } else {
      input.feeds.push_back(feed(hierarchy, names, *node));
    }
    child.inputs.push_back(std::move(input));
  }

  /// True if a child has a key of this name itself, such as the `trigger` of a block with a reset.
  bool has_key(const BlockReference& child, const char* key) const {
    if (!child.part) return type_of(child).input(key) >= 0 || type_of(child).parameter(key);
    return std::ranges::find(child.part->inputs, key) != child.part->inputs.end();
  }

  /// Adds the signals of the formula that enables a child.
  void add_condition(const Hierarchy& hierarchy, const diagram::Scope& names, BlockReference& child,
                     const char* key) {
    const yaml::Node* node = child.written->find(key);
    if (node && has_key(child, key) && !diagram::is_condition(key, *node)) return;
    const yaml::Node* when = node && node->is_map() ? node->find("when") : node;
    if (!when || !when->is_scalar()) return;
    ReferenceInput input{key, {}, true};
    for (const std::string& signal : diagram::signals_of_condition(*when))
      if (const auto found = source(hierarchy, names, signal)) input.feeds.push_back({found, {}});
    if (input.feeds.empty()) input.feeds.push_back({{}, when->text});
    child.inputs.push_back(std::move(input));
  }

  WireFeed feed(const Hierarchy& hierarchy, const diagram::Scope& names, const yaml::Node& node) {
    if (!diagram::names_signal(node)) return {{}, printed_value(node)};
    const auto found = source(hierarchy, names, node.text);
    if (!found) return {};
    if (found->child >= 0) return wired(hierarchy, *found, node.text);
    // An input of a part without a source has the part's default.
    const std::string& port = hierarchy.inputs[static_cast<std::size_t>(found->port)];
    const yaml::Node* fallback = unfed_default(hierarchy, port);
    return fallback ? feed(hierarchy, names, *fallback) : wired(hierarchy, *found, node.text);
  }

  /// Returns the drawn form of a wire with this text.
  WireFeed wired(const Hierarchy& hierarchy, const WireSource& source, const std::string& text) const {
    WireFeed feed{source, {}};
    std::string whole = text;
    diagram::take_element(whole);
    const std::string& prefix = diagram_.scopes[static_cast<std::size_t>(hierarchy.scope)].prefix;
    const std::string start = start_of(hierarchy, source, whole);
    if (text.size() > start.size()) feed.element = text.substr(start.size() + 1);
    const auto below = [&](const std::string& name) {
      const auto first = bus_fields_.lower_bound(prefix + name + ".");
      return first != bus_fields_.end() && first->starts_with(prefix + name + ".");
    };
    feed.is_bus = whole == text &&
                  (below(whole) || (start == whole && below(whole + "." + port_name(hierarchy, source))));
    return feed;
  }

  static const std::string& port_name(const Hierarchy& hierarchy, const WireSource& source) {
    const auto port = static_cast<std::size_t>(source.port);
    return source.child < 0 ? hierarchy.inputs[port]
                            : hierarchy.children[static_cast<std::size_t>(source.child)].outputs[port];
  }

  /// Returns the part of a reference that names the port itself.
  static std::string start_of(const Hierarchy& hierarchy, const WireSource& source, const std::string& text) {
    const std::string& port = port_name(hierarchy, source);
    if (source.child < 0) return port;
    const std::string& name = hierarchy.children[static_cast<std::size_t>(source.child)].name;
    const std::string full = name + "." + port;
    return text == full || text.starts_with(full + ".") ? full : name;
  }

  /// Returns the default of an input of a part that has no source; nullptr otherwise.
  const yaml::Node* unfed_default(const Hierarchy& hierarchy, const std::string& port) {
    if (hierarchy.scope == 0) return nullptr;
    const diagram::ScopeInfo& info = diagram_.scopes[static_cast<std::size_t>(hierarchy.scope)];
    const yaml::Node& user = user_of(info);
    if (user.find(port)) return nullptr;
    const yaml::Node& declared = *loader_.document(info.file).root.find("inputs")->find(port);
    return declared.is_map() ? declared.find("default") : nullptr;
  }

  /// Returns the keys with which a file uses a part.
  const yaml::Node& user_of(const diagram::ScopeInfo& info) {
    const diagram::ScopeInfo& user = diagram_.scopes[static_cast<std::size_t>(info.used_at.scope)];
    const std::string name =
        info.prefix.substr(user.prefix.size(), info.prefix.size() - user.prefix.size() - 1);
    return *loader_.document(user.file).root.find("blocks")->find(name);
  }

  std::optional<WireSource> source(const Hierarchy& hierarchy, const diagram::Scope& names,
                                   const std::string& text) const {
    if (const int port = start_among(hierarchy.inputs, text); port >= 0) return WireSource{-1, port};
    std::string whole = text;
    diagram::take_element(whole);
    const std::string_view name = names.start_of(whole);
    for (std::size_t i = 0; i < hierarchy.children.size(); ++i) {
      const BlockReference& child = hierarchy.children[i];
      if (child.name != name) continue;
      const bool is_only = child.is_bus() || name.size() == whole.size();
      int port = is_only ? 0 : start_among(child.outputs, whole.substr(name.size() + 1));
      const bool is_copied = child.block >= 0 && !block_of(child).copy_of.empty();
      if (port < 0 && is_copied) port = 0;  // field of a bus that the block passes through
      if (port >= 0) return WireSource{static_cast<int>(i), port};
    }
    return std::nullopt;
  }

  /// Returns the index of the name that is the beginning of a dotted text.
  static int start_among(const std::vector<std::string>& names, const std::string& text) {
    for (std::size_t i = 0; i < names.size(); ++i)
      if (text == names[i] || text.starts_with(names[i] + ".")) return static_cast<int>(i);
    return -1;
  }

  const diagram::Diagram& diagram_;
  diagram::Loader& loader_;
  std::map<std::string, int> blocks_, scopes_;
  std::set<std::string> bus_fields_;  ///< full names
};

}  // namespace

std::optional<diagram::SignalRef> Hierarchy::signal(const WireSource& source) const {
  const auto port = static_cast<std::size_t>(source.port);
  if (source.child >= 0) {
    const BlockReference& from = children[static_cast<std::size_t>(source.child)];
    if (from.is_active(source.port)) return diagram::SignalRef{from.guard, 0, -1};
    if (from.is_bus()) return std::nullopt;
    if (!from.part) return diagram::SignalRef{from.block, source.port, -1};
    const auto& inner = from.part->output_sources[port];
    return inner ? from.part->signal(*inner) : std::nullopt;
  }
  if (!parent) return std::nullopt;
  for (const ReferenceInput& input : parent->children[static_cast<std::size_t>(place)].inputs)
    if (input.name == inputs[port] && input.feeds.front().source)
      return parent->signal(*input.feeds.front().source);
  return std::nullopt;
}

std::unique_ptr<Hierarchy> hierarchy_of(const diagram::Diagram& diagram, diagram::Loader& loader, int scope) {
  return OutlineReader(diagram, loader).read(scope);
}

}  // namespace stepwire::drawing
