#include "engine/app/language/language_server.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/app/language/protocol.hpp"

namespace stepwire::language {

using json::Json;

namespace {

/// Pause without messages before files are analysed, so that the analysis does not delay a typing user.
constexpr std::chrono::milliseconds quiet{15};
constexpr std::size_t most_cancelled = 256;
constexpr std::string_view cancel = "$/cancelRequest";

/// Returns the id of a cancelled request, as JSON text; empty for any other message.
std::string cancelled_by(const std::string& message) {
  if (message.find(cancel) == std::string::npos) return "";
  try {
    const Json read = Json::parse(message);
    const Json* method = read.find("method");
    const Json* params = read.find("params");
    const Json* id = params ? params->find("id") : nullptr;
    const bool is = method && method->as_text() && *method->as_text() == cancel && id;
    return is ? id->text(-1) : "";
  } catch (const json::JsonError&) {
    return "";
  }
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
  const std::string id = cancelled_by(message);
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
    send(Json::object().set("jsonrpc", "2.0").set("id", id).set("result", std::move(result)));
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
  Json error = Json::object().set("code", code).set("message", message);
  send(Json::object().set("jsonrpc", "2.0").set("id", id).set("error", std::move(error)));
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

}  // namespace stepwire::language
