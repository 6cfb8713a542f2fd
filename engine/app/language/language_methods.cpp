// Methods of the protocol.
#include "engine/app/language/language_server.hpp"
#include "engine/app/language/protocol.hpp"

namespace stepwire::language {

using json::Json;

namespace {

EditorPosition at(const Json& params) {
  return position_of(member(params, "position"));
}

Json capabilities() {
  Json sync = Json::object()
                  .set("openClose", true)
                  .set("change", 2)  // incremental
                  .set("save", Json::object().set("includeText", false));
  Json completion = Json::object().set("triggerCharacters", Json::list({".", "$", ":", " ", "/"}));
  return Json::object()
      .set("positionEncoding", "utf-16")
      .set("textDocumentSync", std::move(sync))
      .set("completionProvider", std::move(completion))
      .set("hoverProvider", true)
      .set("definitionProvider", true)
      .set("referencesProvider", true)
      .set("renameProvider", Json::object().set("prepareProvider", true))
      .set("documentSymbolProvider", true)
      .set("codeActionProvider", Json::object().set("codeActionKinds", Json::list({"quickfix"})));
}

/// Returns the workspace folders, from the newest field that the editor sends.
std::vector<std::string> folders_of(const Json& params) {
  std::vector<std::string> folders;
  const Json* all = params.find("workspaceFolders");
  for (const Json& folder : all ? all->items() : std::span<const Json>())
    if (const Json* uri = folder.find("uri"); uri && uri->as_text())
      folders.push_back(path_of_uri(*uri->as_text()));
  const Json* root = params.find("rootUri");
  if (folders.empty() && root && root->as_text()) folders.push_back(path_of_uri(*root->as_text()));
  return folders;
}

}  // namespace

Json LanguageServer::initialize(const Json& params) {
  if (initialized_) throw ProtocolError(rpc::invalid_request, "'initialize' comes once");
  initialized_ = true;
  service_.set_folders(folders_of(params));
  return Json::object()
      .set("capabilities", capabilities())
      .set("serverInfo", Json::object().set("name", "stepwire"));
}

Json LanguageServer::shutdown(const Json&) {
  shut_down_ = true;
  return {};
}

void LanguageServer::exit(const Json&) {
  ended_ = true;
}

void LanguageServer::did_open(const Json& params) {
  const std::string file = file_of(params);
  const Json& document = member(params, "textDocument");
  service_.open(file, text_member(document, "text"));
  if (const Json* version = document.find("version")) versions_[file] = *version;
}

void LanguageServer::did_change(const Json& params) {
  const std::string file = file_of(params);
  for (const Json& change : member(params, "contentChanges").items()) {
    const Json* range = change.find("range");
    if (range && !range->is_null())
      service_.edit(file, range_of(*range), text_member(change, "text"));
    else
      service_.open(file, text_member(change, "text"));
  }
  if (const Json* version = member(params, "textDocument").find("version")) versions_[file] = *version;
}

void LanguageServer::did_close(const Json& params) {
  const std::string file = file_of(params);
  service_.close(file);
  versions_.erase(file);
}

void LanguageServer::did_save(const Json&) {
  service_.note_saved();
}

Json LanguageServer::completion(const Json& params) {
  Json items = Json::list();
  int order = 0;
  for (const auto& [one, range] : service_.completions(file_of(params), at(params)))
    items.push(json_of(one, range, order++));
  return Json::object().set("isIncomplete", false).set("items", std::move(items));
}

Json LanguageServer::hover(const Json& params) {
  const auto found = service_.hover(file_of(params), at(params));
  if (!found) return {};
  Json contents = Json::object().set("kind", "markdown").set("value", found->first);
  return Json::object().set("contents", std::move(contents)).set("range", json_of(found->second));
}

Json LanguageServer::place_json(const EditorPlace& place) {
  return Json::object().set("uri", uris_.uri(place.file)).set("range", json_of(place.range));
}

Json LanguageServer::definition(const Json& params) {
  const auto place = service_.definition(file_of(params), at(params));
  return place ? place_json(*place) : Json();
}

Json LanguageServer::references(const Json& params) {
  const Json* context = params.find("context");
  const Json* declaration = context ? context->find("includeDeclaration") : nullptr;
  Json places = Json::list();
  for (const EditorPlace& place : service_.references(file_of(params), at(params),
                                                      declaration && declaration->as_flag().value_or(false)))
    places.push(place_json(place));
  return places;
}

Json LanguageServer::prepare_rename(const Json& params) {
  return json_of(service_.renamed(file_of(params), at(params)));
}

Json LanguageServer::edits_json(const FileEdits& edits) {
  Json changes = Json::object();
  for (const auto& [file, list] : edits) {
    Json all = Json::list();
    for (const auto& [range, text] : list)
      all.push(Json::object().set("range", json_of(range)).set("newText", text));
    changes.set(uris_.uri(file), std::move(all));
  }
  return Json::object().set("changes", std::move(changes));
}

Json LanguageServer::rename(const Json& params) {
  return edits_json(service_.rename(file_of(params), at(params), text_member(params, "newName")));
}

Json LanguageServer::document_symbols(const Json& params) {
  Json items = Json::list();
  for (const OutlineItem& item : service_.outline(file_of(params))) items.push(json_of(item));
  return items;
}

Json LanguageServer::code_actions(const Json& params) {
  const std::string file = file_of(params);
  Json actions = Json::list();
  for (const Mending& one : service_.mendings(file, range_of(member(params, "range")))) {
    Json diagnostic = Json::object()
                          .set("range", json_of(one.diagnostic.range))
                          .set("severity", 1)
                          .set("source", "stepwire")
                          .set("message", one.diagnostic.message);
    actions.push(Json::object()
                     .set("title", one.title)
                     .set("kind", "quickfix")
                     .set("isPreferred", true)
                     .set("diagnostics", Json::list({std::move(diagnostic)}))
                     .set("edit", edits_json({{file, {{one.range, one.text}}}})));
  }
  return actions;
}

}  // namespace stepwire::language
