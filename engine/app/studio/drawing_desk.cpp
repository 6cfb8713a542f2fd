#include "engine/app/studio/drawing_desk.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/app/language/edits.hpp"
#include "engine/app/reference/block_json.hpp"
#include "engine/app/studio/named_faults.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/view/drawing/draw.hpp"

namespace stepwire::studio {

using json::Json;

namespace {

/// Returns the scope of a part by its path in the diagram: "" is the diagram itself, "rig.mount" a nested
/// part.
int scope_of(const drawing::DiagramView& whole, const std::string& name) {
  const auto& scopes = whole.diagram().scopes;
  const auto found = std::ranges::find(scopes, name + ".", &diagram::ScopeInfo::prefix);
  if (found == scopes.end()) throw Fault(fmt::format("the diagram has no part '{}'", text::visible(name)));
  return static_cast<int>(found - scopes.begin());
}

Json graph(Desk& desk, DrawingDesk& texts, const Arguments& arguments) {
  diagram::Loader loader(desk.registry);
  const std::string path = add_documents(desk, arguments.whole("file"), loader);
  const drawing::DrawnFile file(loader, path);
  drawing::GraphOptions options;
  options.open = arguments.texts("open");
  options.units = arguments.flag("units");
  const std::string scope = arguments.text("scope");
  const int place = scope.empty() ? file.view().scope() : scope_of(file.view(), scope);
  const drawing::DiagramView part(file.view().diagram(), loader, place);
  return Json::object()
      .set("graph", part.graph(options))
      .set("ranges", texts.ranges(part.diagram().scopes[static_cast<std::size_t>(place)].file));
}

}  // namespace

void DrawingDesk::follow() {
  for (const auto& [path, text] : desk_.files.texts().all()) {
    const auto [known, is_new] = versions_.try_emplace(path, text.version);
    if (!is_new && known->second == text.version) continue;
    known->second = text.version;
    service_.open(path, text.text);
  }
}

std::string DrawingDesk::path(const Arguments& arguments) {
  const std::string path = desk_.files.path(arguments.whole("file"));
  desk_.files.texts().require_version(path, arguments.whole("version"));
  follow();
  return path;
}

Json DrawingDesk::range(const language::Utf16Range& range) {
  return Json::object()
      .set("file", desk_.files.number(range.file))
      .set("from", range.from)
      .set("to", range.to);
}

Json DrawingDesk::ranges(const std::string& path) {
  const std::lock_guard lock(desk_.mutex);
  follow();
  Json ranges = Json::object();
  for (const auto& [name, place] : service_.shapes(path)) ranges.set(name, range(place));
  return ranges;
}

Json DrawingDesk::splice(const Arguments& arguments) {
  const std::lock_guard lock(desk_.mutex);
  const std::string file = path(arguments);
  const language::EditChanges edited = service_.edited(file, language::edit_of(arguments.any("edit")));
  Json changes = Json::list();
  for (const auto& change : edited.changes) changes.push(range(change.range).set("text", change.text));
  return Json::object()
      .set("changes", std::move(changes))
      .set("name", edited.name)
      .set("faults", faults_with_names(desk_.files, edited.faults));
}

Json DrawingDesk::fits(const Arguments& arguments) {
  const std::lock_guard lock(desk_.mutex);
  const std::string file = path(arguments);
  Json inputs = Json::list();
  for (const language::InputName& one : service_.inputs_for(file, arguments.text("from")))
    inputs.push(Json::object().set("node", one.block).set("input", one.input));
  return Json::object().set("inputs", std::move(inputs));
}

std::string add_documents(Desk& desk, int file, diagram::Loader& loader) {
  const std::lock_guard lock(desk.mutex);
  const std::string& path = desk.files.path(file);
  for (yaml::Document& document : desk.files.documents(path)) loader.add(std::move(document));
  return path;
}

void add_drawing_calls(Calls& calls, Desk& desk, DrawingDesk& texts) {
  calls["graph"] = {
      [&](int, const Arguments& it) { return with_names(desk, [&] { return graph(desk, texts, it); }); }};
  calls["splice"] = {
      [&](int, const Arguments& it) { return with_names(desk, [&] { return texts.splice(it); }); }};
  calls["fits"] = {
      [&](int, const Arguments& it) { return with_names(desk, [&] { return texts.fits(it); }); }};
  calls["blocks"] = {[&desk](int, const Arguments&) {
    return Json::object().set("blocks", reference::blocks_json(desk.registry));
  }};
}

}  // namespace stepwire::studio
