#include "engine/view/drawing/draw.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "engine/base/hash/hash.hpp"
#include "engine/base/io/cache.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/io/resources.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/model/diagram/part_alone.hpp"
#include "engine/model/diagram/report.hpp"
#include "engine/model/diagram/units.hpp"
#include "engine/view/drawing/chart_graph.hpp"

namespace stepwire::drawing {

namespace {

diagram::Diagram load(diagram::Loader& loader, const std::string& path) {
  const yaml::Node& root = loader.document(path).root;
  if (!root.is_map() || !diagram::is_part(root)) return loader.load(path);
  yaml::Document user = diagram::user_of_part(path, root);
  const std::string name = user.file;
  loader.add(std::move(user));
  return loader.load(name);
}

/// Returns the diagram with units. They are found without a plan, so that a diagram with loops that cannot be
/// ordered can be drawn too.
diagram::Diagram with_units(diagram::Diagram diagram) {
  diagram::Report report(diagram);
  diagram::infer_units(report);
  report.faults().throw_if_any();
  return diagram;
}

/// Returns a hash of all inputs of a picture: the graph, the drawing modules, and the version of elkjs.
std::string hash_of_picture(const std::string& module, const std::string& drawn) {
  std::vector<std::filesystem::path> files{module + "/package-lock.json"};
  for (const auto& entry : std::filesystem::directory_iterator(module))
    if (entry.path().extension() == ".mjs") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  hash::Hash hash;
  for (const std::filesystem::path& file : files) hash.add(io::read_file(file.string()));
  return hash.add(drawn).text();
}

void add_names(const Hierarchy& hierarchy, const std::string& above, bool signals,
               std::vector<std::string>& names) {
  for (const BlockReference& child : hierarchy.children) {
    const std::string name = above + child.name;
    names.push_back(name);
    if (signals)
      for (const std::string& output : child.outputs) names.push_back(name + "." + output);
    if (child.part) add_names(*child.part, name + ".", signals, names);
  }
}

}  // namespace

std::vector<std::string> DiagramView::parts() const {
  const std::string& above = diagram_.scopes[static_cast<std::size_t>(scope_)].prefix;
  std::vector<std::string> names;
  for (const diagram::ScopeInfo& scope : diagram_.scopes)
    if (scope.prefix.starts_with(above) && scope.prefix != above)
      names.push_back(scope.prefix.substr(above.size(), scope.prefix.size() - above.size() - 1));
  for (const diagram::DiagramBlock& block : diagram_.blocks)  // blocks with states can be opened too
    if (block.name.starts_with(above) && chart_of(block)) names.push_back(block.name.substr(above.size()));
  return names;
}

json::Json DiagramView::graph(const GraphOptions& options) const {
  const std::string& file = diagram_.scopes[static_cast<std::size_t>(scope_)].file;
  const yaml::Node* title = loader_.document(file).root.find("title");
  json::Json graph = graph_of(diagram_, *hierarchy_of(diagram_, loader_, scope_), options);
  return graph.set("title", title ? title->text : "");
}

std::vector<std::string> DiagramView::blocks(bool signals) const {
  std::vector<std::string> names;
  const auto hierarchy = hierarchy_of(diagram_, loader_, scope_);
  add_names(*hierarchy, "", signals, names);
  if (signals) names.insert(names.end(), hierarchy->outputs.begin(), hierarchy->outputs.end());
  return names;
}

std::vector<std::string> DiagramView::children() const {
  std::vector<std::string> names;
  const auto hierarchy = hierarchy_of(diagram_, loader_, scope_);
  for (const BlockReference& child : hierarchy->children) names.push_back(child.name);
  return names;
}

std::vector<std::string> DiagramView::signals(const GraphOptions& options) const {
  return drawn_signals(diagram_, *hierarchy_of(diagram_, loader_, scope_), options);
}

DrawnFile::DrawnFile(diagram::Loader& loader, const std::string& path)
    : diagram_(with_units(load(loader, path))), view_(diagram_, loader, diagram_.file == path ? 0 : 1) {}

std::string draw_picture(const json::Json& drawn) {
  const std::string node = subprocess::find_program("node");
  if (node.empty()) throw io::EnvironmentError("node is not installed; on Debian it is the package nodejs");
  const std::string text = drawn.text(-1);
  const std::string module = io::resource("drawing");
  const io::Cache cache;
  const std::string name = hash_of_picture(module, text) + ".svg";
  if (std::optional<std::string> picture = cache.find(name)) return *std::move(picture);
  const subprocess::ProcessResult answer =
      subprocess::run_helper("node", {.command = {node, module + "/main.mjs"}, .input = text});
  cache.keep(name, answer.output);
  return answer.output;
}

}  // namespace stepwire::drawing
