#include "engine/app/language/language_server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "engine/app/language/json_rpc.hpp"

namespace stepwire::language {

using json::Json;

namespace {

/// Returns a number from 0 on. Throws ProtocolError for a missing or other one.
int whole(const Json& object, const char* name) {
  const auto number = member(object, name).as_number();
  if (!number || !(*number >= 0.0))
    throw ProtocolError(rpc::invalid_params, fmt::format("'{}' is no number from 0 on", name));
  return static_cast<int>(std::min<double>(*number, std::numeric_limits<int>::max()));
}

/// Returns the CompletionItemKind of the protocol.
int kind_of(Completion::Kind kind) {
  switch (kind) {
    case Completion::Kind::key:
      return 10;  // Property
    case Completion::Kind::type:
      return 7;  // Class
    case Completion::Kind::word:
      return 12;  // Value
    case Completion::Kind::signal:
      return 6;  // Variable
    case Completion::Kind::parameter:
      return 21;  // Constant
    case Completion::Kind::unit:
      return 11;  // Unit
    default:
      return 17;  // File
  }
}

/// Returns the SymbolKind of the protocol.
int kind_of(OutlineItem::Kind kind) {
  switch (kind) {
    case OutlineItem::Kind::section:
      return 3;  // Namespace
    case OutlineItem::Kind::block:
      return 19;  // Object
    case OutlineItem::Kind::part:
      return 2;  // Module
    case OutlineItem::Kind::parameter:
      return 14;  // Constant
    case OutlineItem::Kind::port:
      return 8;  // Field
    default:
      return 17;  // Boolean
  }
}

EditorPosition position_of(const Json& position) {
  return {whole(position, "line"), whole(position, "character")};
}

EditorRange range_of(const Json& range) {
  return {position_of(member(range, "start")), position_of(member(range, "end"))};
}

Json json_of(const EditorPosition& position) {
  return Json::object().set("line", position.line).set("character", position.character);
}

Json json_of(const EditorRange& range) {
  return Json::object().set("start", json_of(range.start)).set("end", json_of(range.end));
}

Json json_of(const Completion& completion, const EditorRange& range, int order) {
  Json edit = Json::object().set("range", json_of(range)).set("newText", completion.text);
  Json item = Json::object()
                  .set("label", completion.label)
                  .set("kind", kind_of(completion.kind))
                  .set("sortText", fmt::format("{:06}", order))
                  .set("textEdit", std::move(edit));
  if (!completion.detail.empty()) item.set("detail", completion.detail);
  if (!completion.doc.empty())
    item.set("documentation", Json::object().set("kind", "markdown").set("value", completion.doc));
  return item;
}

Json json_of(const OutlineItem& item) {
  Json children = Json::list();
  for (const OutlineItem& child : item.children) children.push(json_of(child));
  return Json::object()
      .set("name", item.name)
      .set("detail", item.detail)
      .set("kind", kind_of(item.kind))
      .set("range", json_of(item.range))
      .set("selectionRange", json_of(item.name_range))
      .set("children", std::move(children));
}

/// Pause without messages before files are analysed, so that the analysis does not delay a typing user.
constexpr std::chrono::milliseconds quiet{15};
constexpr std::size_t most_cancelled = 256;
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

LanguageServer::LanguageServer(const Registry& registry, Send send, FileUris uris, FileAccess access)
    : service_(registry, std::move(access)), send_(std::move(send)), uris_(std::move(uris)) {}

const std::map<std::string, LanguageServer::Answer>& LanguageServer::requests() {
  static const std::map<std::string, Answer> all{
      {"initialize", &LanguageServer::initialize},
      {"shutdown", &LanguageServer::shutdown},
      {"textDocument/completion", &LanguageServer::completion},
      {"textDocument/hover", &LanguageServer::hover},
      {"textDocument/definition", &LanguageServer::definition},
      {"textDocument/references", &LanguageServer::references},
      {"textDocument/prepareRename", &LanguageServer::prepare_rename},
      {"textDocument/rename", &LanguageServer::rename},
      {"textDocument/documentSymbol", &LanguageServer::document_symbols},
      {"textDocument/codeAction", &LanguageServer::code_actions}};
  return all;
}

const std::map<std::string, void (LanguageServer::*)(const Json&)>& LanguageServer::notifications() {
  static const std::map<std::string, void (LanguageServer::*)(const Json&)> all{
      {"textDocument/didOpen", &LanguageServer::did_open},
      {"textDocument/didChange", &LanguageServer::did_change},
      {"textDocument/didClose", &LanguageServer::did_close},
      {"textDocument/didSave", &LanguageServer::did_save},
      {"workspace/didChangeWatchedFiles", &LanguageServer::did_save},
      {"exit", &LanguageServer::exit}};
  return all;
}

void LanguageServer::post(std::string message, std::shared_ptr<void> held) {
  const std::string id = cancelled_id(message, "$/cancelRequest", "id");
  const std::scoped_lock lock(mutex_);
  if (id.empty())
    messages_.push_back({std::move(message), std::move(held)});
  else
    cancelled_.push_back(id);
  // Ids that arrive after their answer stay until they are the oldest.
  if (cancelled_.size() > most_cancelled) cancelled_.erase(cancelled_.begin());
  arrived_.notify_one();
}

void LanguageServer::close() {
  const std::scoped_lock lock(mutex_);
  closed_ = true;
  arrived_.notify_one();
}

void LanguageServer::abandon() {
  const std::scoped_lock lock(mutex_);
  messages_.clear();
  closed_ = true;
  arrived_.notify_one();
}

std::optional<LanguageServer::Message> LanguageServer::next_message() {
  std::unique_lock lock(mutex_);
  arrived_.wait(lock, [&] { return closed_ || !messages_.empty(); });
  if (messages_.empty()) return std::nullopt;
  Message message = std::move(messages_.front());
  messages_.pop_front();
  return message;
}

bool LanguageServer::is_quiet() {
  std::unique_lock lock(mutex_);
  return !arrived_.wait_for(lock, quiet, [&] { return closed_ || !messages_.empty(); });
}

bool LanguageServer::run() {
  while (!ended_) {
    const auto message = next_message();
    if (!message) break;
    handle(message->text);
    while (!ended_ && is_quiet() && service_.analyse_next()) publish();
    if (!ended_) publish();
  }
  return ended_ && shut_down_;
}

void LanguageServer::handle(const std::string& text) {
  Json id;
  try {
    const Json message = Json::parse(text);
    if (const Json* given = message.find("id")) id = *given;
    if (!message.is_object()) return send_error(Json(), rpc::invalid_request, "a message is an object");
    if (!message.find("method") && message.find("id")) return;  // an answer; the server sends no requests
    const std::string& method = text_member(message, "method");
    static const Json none = Json::object();
    const Json* params = message.find("params");
    if (message.find("id")) return answer(id, method, params ? *params : none);
    const auto known = notifications().find(method);
    if (known != notifications().end() && (initialized_ || method == "exit"))
      (this->*known->second)(params ? *params : none);
  } catch (const json::JsonError& error) {
    send_error(Json(), rpc::parse_error, std::string("this message is no JSON: ") + error.what());
  } catch (const ProtocolError& error) {
    // A notification has no answer; a faulty one is ignored.
    if (!id.is_null()) send_error(id, error.code, error.what());
  } catch (const EditRefused&) {  // a change outside of the text
  }
}

void LanguageServer::answer(const Json& id, const std::string& method, const Json& params) {
  try {
    if (take_cancelled(id)) throw ProtocolError(rpc::request_cancelled, "cancelled");
    if (shut_down_) throw ProtocolError(rpc::invalid_request, "the server is shut down");
    if (!initialized_ && method != "initialize")
      throw ProtocolError(rpc::not_initialized, "'initialize' comes first");
    const auto known = requests().find(method);
    if (known == requests().end())
      throw ProtocolError(rpc::no_method, fmt::format("there is no method '{}'", method));
    Json result = (this->*known->second)(params);
    send(answer_message(id, std::move(result)));
  } catch (const ProtocolError& error) {
    send_error(id, error.code, error.what());
  } catch (const EditRefused& refused) {
    send_error(id, rpc::request_failed, refused.what());
  } catch (const std::exception& error) {
    send_error(id, rpc::internal_error, error.what());
  }
}

bool LanguageServer::take_cancelled(const Json& id) {
  const std::scoped_lock lock(mutex_);
  const auto found = std::ranges::find(cancelled_, id.text(-1));
  if (found == cancelled_.end()) return false;
  cancelled_.erase(found);
  return true;
}

void LanguageServer::send(const Json& message) {
  send_(message.text(-1));
}

void LanguageServer::send_error(const Json& id, int code, const std::string& message) {
  send(error_message(id, code, message));
}

std::string LanguageServer::file_of(const Json& params) {
  std::string file = uris_.path(text_member(member(params, "textDocument"), "uri"));
  if (file.empty()) throw ProtocolError(rpc::invalid_params, "there is no document of this address");
  return file;
}

void LanguageServer::publish() {
  for (const auto& [file, list] : service_.take_diagnostics()) {
    Json diagnostics = Json::list();
    for (const TextDiagnostic& one : list) {
      Json related = Json::list();
      for (const TextDiagnostic::Related& other : one.related)
        related.push(Json::object()
                         .set("location", place_json({other.file, other.range}))
                         .set("message", other.message));
      diagnostics.push(Json::object()
                           .set("range", json_of(one.range))
                           .set("severity", 1)
                           .set("source", "stepwire")
                           .set("message", one.message)
                           .set("relatedInformation", std::move(related)));
    }
    Json params = Json::object().set("uri", uris_.uri(file)).set("diagnostics", std::move(diagnostics));
    if (const auto version = versions_.find(file); version != versions_.end())
      params.set("version", version->second);
    send(Json::object()
             .set("jsonrpc", "2.0")
             .set("method", "textDocument/publishDiagnostics")
             .set("params", std::move(params)));
  }
}

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
