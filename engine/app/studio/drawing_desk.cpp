#include "engine/app/studio/drawing_desk.hpp"

#include "engine/app/language/edit_json.hpp"
#include "engine/app/studio/named_faults.hpp"

namespace stepwire::studio {

using json::Json;

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

}  // namespace stepwire::studio
