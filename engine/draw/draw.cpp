#include "engine/draw/draw.hpp"

#include <filesystem>

#include "engine/diagram/report.hpp"
#include "engine/diagram/units.hpp"
#include "engine/diagram/written.hpp"
#include "engine/process/filter.hpp"
#include "engine/table/surroundings.hpp"

namespace stepwire {

namespace {

/// Is this to be used in other files only? It does not say for how long it runs, or nothing feeds one of its
/// inputs.
bool is_part(const Node& root) {
  if (!root.find("stop")) return true;
  if (const Node* inputs = root.find("inputs"))
    for (const Entry& input : inputs->entries)
      if (!input.value.is_map() || !input.value.find("default")) return true;
  return false;
}

/// A diagram that consists of one part, whose inputs are fed by zeros.
Document user_of(const std::string& path, const Node& part) {
  Node keys;
  add_key(keys, "diagram", written_filled_in(std::filesystem::path(path).filename().string()));
  if (const Node* inputs = part.find("inputs"))
    for (const Entry& input : inputs->entries) add_key(keys, input.key, written_text("0"));
  Document user{path + " alone", {}};
  add_key(user.root, "stepwire", written_text("1"));
  add_key(user.root, "step", written_text("1"));
  add_key(user.root, "stop", written_text("1"));
  Node blocks;
  add_key(blocks, "part", std::move(keys));
  add_key(user.root, "blocks", std::move(blocks));
  return user;
}

Diagram load(Loader& loader, const std::string& path) {
  const Node& root = loader.document(path).root;
  if (!root.is_map() || !is_part(root)) return loader.load(path);
  Document user = user_of(path, root);
  const std::string name = user.file;
  loader.add(std::move(user));
  return loader.load(name);
}

}  // namespace

DrawnFile::DrawnFile(Loader& loader, const std::string& path) : diagram_(load(loader, path)) {
  Report report(diagram_);
  infer_units(report);
  report.faults().throw_if_any();
  if (const Node* title = loader.document(path).root.find("title")) title_ = title->text;
  outline_ = outline_of(diagram_, loader);
  if (diagram_.file == path) return;
  auto part = std::move(outline_->children.front().part);
  part->parent = nullptr;
  outline_ = std::move(part);
}

std::vector<std::string> DrawnFile::parts() const {
  const std::string& above = diagram_.scopes[static_cast<std::size_t>(outline_->scope)].prefix;
  std::vector<std::string> names;
  for (const ScopeInfo& scope : diagram_.scopes)
    if (scope.prefix.starts_with(above) && scope.prefix != above)
      names.push_back(scope.prefix.substr(above.size(), scope.prefix.size() - above.size() - 1));
  return names;
}

Json DrawnFile::graph(const GraphOptions& options) const {
  return graph_of(diagram_, *outline_, options).set("title", title_);
}

std::string draw_graph(const Json& graph) {
  const std::string node = find_program("node");
  if (node.empty()) throw SurroundingsError("node is not installed; on Debian it is the package nodejs");
  const FilterAnswer answer = run_filter(node, {STEPWIRE_DRAW "/main.mjs"}, graph.text(-1));
  if (answer.status != 0) throw SurroundingsError(answer.complaints);
  return answer.output;
}

}  // namespace stepwire
