#include "engine/view/drawing/hierarchy.hpp"

#include <algorithm>
#include <map>

#include "engine/model/diagram/guard_keys.hpp"
#include "engine/model/diagram/guard_types.hpp"
#include "engine/model/diagram/resolve.hpp"
#include "engine/view/drawing/symbol_text.hpp"

namespace stepwire::drawing {

namespace {

int index_of(const std::vector<std::string>& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

class OutlineReader {
 public:
  OutlineReader(const diagram::Diagram& diagram, diagram::Loader& loader)
      : diagram_(diagram), loader_(loader) {
    for (std::size_t i = 0; i < diagram.blocks.size(); ++i)
      blocks_[diagram.blocks[i].name] = static_cast<int>(i);
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
    } else {
      child.block = blocks_.at(prefix + entry.key);
      for (const OutputSpec& output : type_of(child).outputs) child.outputs.push_back(output.name);
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

  const BlockType& type_of(const BlockReference& child) const {
    return diagram_.blocks[static_cast<std::size_t>(child.block)].type();
  }

  /// Finds what feeds what, once all children are known.
  void connect(Hierarchy& hierarchy, const yaml::Node& root) {
    diagram::Scope names;
    for (const BlockReference& child : hierarchy.children) names.names[child.name];
    for (std::size_t i = 0; i < hierarchy.children.size(); ++i) {
      BlockReference& child = hierarchy.children[i];
      if (child.part) {
        child.part->parent = &hierarchy;
        child.part->place = static_cast<int>(i);
        for (const std::string& input : child.part->inputs) add_input(hierarchy, names, child, input, false);
      } else {
        for (const InputSpec& input : type_of(child).inputs)
          add_input(hierarchy, names, child, input.name, input.list);
      }
      if (child.guard >= 0)
        for (const char* key : {"enable", "trigger"}) add_condition(hierarchy, names, child, key);
    }
    for (const std::string& output : hierarchy.outputs) {
      const yaml::Node& port = *root.find("outputs")->find(output);
      hierarchy.output_sources.push_back(
          source(hierarchy, names, port.is_map() ? port.find("signal")->text : port.text));
    }
  }

  void add_input(const Hierarchy& hierarchy, const diagram::Scope& names, BlockReference& child,
                 const std::string& name, bool list) {
    const yaml::Node* node = child.written->find(name);
    if (!node) return;
    ReferenceInput input{name, {}};
    if (list && node->is_list()) {
      for (const yaml::Node& item : node->items) input.feeds.push_back(feed(hierarchy, names, item));
    } else {
      input.feeds.push_back(feed(hierarchy, names, *node));
    }
    child.inputs.push_back(std::move(input));
  }

  /// What decides when a child is active: the signals of its formula.
  void add_condition(const Hierarchy& hierarchy, const diagram::Scope& names, BlockReference& child,
                     const char* key) {
    const bool is_own =
        std::ranges::any_of(child.inputs, [&](const auto& input) { return input.name == key; });
    const yaml::Node* node = is_own ? nullptr : child.written->find(key);
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
    if (!found || found->child >= 0) return {found, {}};
    // An input that nobody feeds has the part's own default.
    const std::string& port = hierarchy.inputs[static_cast<std::size_t>(found->port)];
    const yaml::Node* fallback = unfed_default(hierarchy, port);
    return fallback ? feed(hierarchy, names, *fallback) : WireFeed{found, {}};
  }

  /// The default of an input of a part that the using file leaves out; null otherwise.
  const yaml::Node* unfed_default(const Hierarchy& hierarchy, const std::string& port) {
    if (hierarchy.scope == 0) return nullptr;
    const diagram::ScopeInfo& info = diagram_.scopes[static_cast<std::size_t>(hierarchy.scope)];
    const yaml::Node& user = user_of(info);
    if (user.find(port)) return nullptr;
    const yaml::Node& declared = *loader_.document(info.file).root.find("inputs")->find(port);
    return declared.is_map() ? declared.find("default") : nullptr;
  }

  /// The keys with which a file uses a part.
  const yaml::Node& user_of(const diagram::ScopeInfo& info) {
    const diagram::ScopeInfo& user = diagram_.scopes[static_cast<std::size_t>(info.used_at.scope)];
    const std::string name =
        info.prefix.substr(user.prefix.size(), info.prefix.size() - user.prefix.size() - 1);
    return *loader_.document(user.file).root.find("blocks")->find(name);
  }

  std::optional<WireSource> source(const Hierarchy& hierarchy, const diagram::Scope& names,
                                   const std::string& text) const {
    if (const int port = index_of(hierarchy.inputs, text); port >= 0) return WireSource{-1, port};
    const std::string_view name = names.start_of(text);
    for (std::size_t i = 0; i < hierarchy.children.size(); ++i) {
      const BlockReference& child = hierarchy.children[i];
      if (child.name != name) continue;
      const int port = name.size() == text.size()
                           ? 0
                           : index_of(child.outputs, std::string_view(text).substr(name.size() + 1));
      if (port >= 0) return WireSource{static_cast<int>(i), port};
    }
    return std::nullopt;
  }

  const diagram::Diagram& diagram_;
  diagram::Loader& loader_;
  std::map<std::string, int> blocks_, scopes_;
};

}  // namespace

std::optional<diagram::SignalRef> Hierarchy::signal(const WireSource& source) const {
  const auto port = static_cast<std::size_t>(source.port);
  if (source.child >= 0) {
    const BlockReference& from = children[static_cast<std::size_t>(source.child)];
    if (from.is_active(source.port)) return diagram::SignalRef{from.guard, 0, -1};
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
