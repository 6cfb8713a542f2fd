#include "engine/view/drawing/sheet.hpp"

#include <algorithm>
#include <map>

#include "engine/model/diagram/resolve.hpp"
#include "engine/view/drawing/symbol_text.hpp"

namespace stepwire {

namespace {

int index_of(const std::vector<std::string>& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

class OutlineReader {
 public:
  OutlineReader(const Diagram& diagram, Loader& loader) : diagram_(diagram), loader_(loader) {
    for (std::size_t i = 0; i < diagram.blocks.size(); ++i)
      blocks_[diagram.blocks[i].name] = static_cast<int>(i);
    for (std::size_t i = 1; i < diagram.scopes.size(); ++i)
      scopes_[diagram.scopes[i].prefix] = static_cast<int>(i);
  }

  std::unique_ptr<Sheet> read(int scope) {
    auto sheet = std::make_unique<Sheet>();
    sheet->scope = scope;
    const ScopeInfo& info = diagram_.scopes[static_cast<std::size_t>(scope)];
    const Node& root = loader_.document(info.file).root;
    sheet->inputs = keys(root, "inputs");
    sheet->outputs = keys(root, "outputs");
    if (const Node* blocks = root.find("blocks"))
      for (const Entry& entry : blocks->entries) sheet->children.push_back(child(entry, info.prefix));
    connect(*sheet, root);
    return sheet;
  }

 private:
  static std::vector<std::string> keys(const Node& root, const char* key) {
    std::vector<std::string> names;
    if (const Node* map = root.find(key))
      for (const Entry& entry : map->entries) names.push_back(entry.key);
    return names;
  }

  SheetChild child(const Entry& entry, const std::string& prefix) {
    SheetChild child;
    child.name = entry.key;
    child.written = &entry.value;
    if (const auto scope = scopes_.find(prefix + entry.key + "."); scope != scopes_.end()) {
      child.part = read(scope->second);
      child.outputs = child.part->outputs;
      return child;
    }
    child.block = blocks_.at(prefix + entry.key);
    for (const OutputSpec& output : type_of(child).outputs) child.outputs.push_back(output.name);
    return child;
  }

  const BlockType& type_of(const SheetChild& child) const {
    return diagram_.blocks[static_cast<std::size_t>(child.block)].type();
  }

  /// Finds what feeds what, once all children are known.
  void connect(Sheet& sheet, const Node& root) {
    Scope names;
    for (const SheetChild& child : sheet.children) names.names[child.name];
    for (std::size_t i = 0; i < sheet.children.size(); ++i) {
      SheetChild& child = sheet.children[i];
      if (child.part) {
        child.part->parent = &sheet;
        child.part->place = static_cast<int>(i);
        for (const std::string& input : child.part->inputs) add_input(sheet, names, child, input, false);
      } else {
        for (const InputSpec& input : type_of(child).inputs)
          add_input(sheet, names, child, input.name, input.list);
      }
    }
    for (const std::string& output : sheet.outputs) {
      const Node& port = *root.find("outputs")->find(output);
      sheet.output_sources.push_back(
          source(sheet, names, port.is_map() ? port.find("signal")->text : port.text));
    }
  }

  void add_input(const Sheet& sheet, const Scope& names, SheetChild& child, const std::string& name,
                 bool list) {
    const Node* node = child.written->find(name);
    if (!node) return;
    SheetInput input{name, {}};
    if (list && node->is_list()) {
      for (const Node& item : node->items) input.feeds.push_back(feed(sheet, names, item));
    } else {
      input.feeds.push_back(feed(sheet, names, *node));
    }
    child.inputs.push_back(std::move(input));
  }

  SheetFeed feed(const Sheet& sheet, const Scope& names, const Node& node) {
    if (!names_signal(node)) return {{}, printed_value(node)};
    const auto found = source(sheet, names, node.text);
    if (!found || found->child >= 0) return {found, {}};
    // An input that nobody feeds has the part's own default.
    const std::string& port = sheet.inputs[static_cast<std::size_t>(found->port)];
    const Node* fallback = unfed_default(sheet, port);
    return fallback ? feed(sheet, names, *fallback) : SheetFeed{found, {}};
  }

  /// The default of an input of a part that the using file leaves out; null otherwise.
  const Node* unfed_default(const Sheet& sheet, const std::string& port) {
    if (sheet.scope == 0) return nullptr;
    const ScopeInfo& info = diagram_.scopes[static_cast<std::size_t>(sheet.scope)];
    const Node& user = user_of(info);
    if (user.find(port)) return nullptr;
    const Node& declared = *loader_.document(info.file).root.find("inputs")->find(port);
    return declared.is_map() ? declared.find("default") : nullptr;
  }

  /// The keys with which a file uses a part.
  const Node& user_of(const ScopeInfo& info) {
    const ScopeInfo& user = diagram_.scopes[static_cast<std::size_t>(info.used_at.scope)];
    const std::string name =
        info.prefix.substr(user.prefix.size(), info.prefix.size() - user.prefix.size() - 1);
    return *loader_.document(user.file).root.find("blocks")->find(name);
  }

  std::optional<SheetSource> source(const Sheet& sheet, const Scope& names, const std::string& text) const {
    if (const int port = index_of(sheet.inputs, text); port >= 0) return SheetSource{-1, port};
    const std::string_view name = names.start_of(text);
    for (std::size_t i = 0; i < sheet.children.size(); ++i) {
      const SheetChild& child = sheet.children[i];
      if (child.name != name) continue;
      const int port = name.size() == text.size()
                           ? 0
                           : index_of(child.outputs, std::string_view(text).substr(name.size() + 1));
      if (port >= 0) return SheetSource{static_cast<int>(i), port};
    }
    return std::nullopt;
  }

  const Diagram& diagram_;
  Loader& loader_;
  std::map<std::string, int> blocks_, scopes_;
};

}  // namespace

std::optional<SignalRef> Sheet::signal(const SheetSource& source) const {
  const auto port = static_cast<std::size_t>(source.port);
  if (source.child >= 0) {
    const SheetChild& from = children[static_cast<std::size_t>(source.child)];
    if (!from.part) return SignalRef{from.block, source.port, -1};
    const auto& inner = from.part->output_sources[port];
    return inner ? from.part->signal(*inner) : std::nullopt;
  }
  if (!parent) return std::nullopt;
  for (const SheetInput& input : parent->children[static_cast<std::size_t>(place)].inputs)
    if (input.name == inputs[port] && input.feeds.front().source)
      return parent->signal(*input.feeds.front().source);
  return std::nullopt;
}

std::unique_ptr<Sheet> reference_of(const Diagram& diagram, Loader& loader, int scope) {
  return OutlineReader(diagram, loader).read(scope);
}

}  // namespace stepwire
