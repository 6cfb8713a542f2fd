#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/language/file_uri.hpp"
#include "engine/app/language/language_service.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::language {

/// Language Server Protocol over any transport of JSON texts. It receives requests and notifications, and
/// sends answers and diagnostics. Source: Language Server Protocol 3.17, JSON-RPC 2.0.
class LanguageServer {
 public:
  /// Sends a message as JSON text; called only on the thread of run().
  using Send = std::function<void(const std::string& message)>;

  LanguageServer(const Registry& registry, Send send, FileUris uris = FileUris(), FileAccess access = {});

  /// Queues a message. Thread-safe. `held` is released after the message is handled.
  void post(std::string message, std::shared_ptr<void> held = {});
  /// Ends run() after the queued messages. Thread-safe.
  void close();
  /// Ends run() after the current message, and drops the queued ones. Thread-safe.
  void abandon();
  /// Handles messages until the editor exits, or until close() or abandon(). Diagnostics are published when
  /// the queue is empty, so a series of changes is analysed once. True if the editor ended the session as the
  /// protocol requires.
  bool run();

 private:
  using Answer = json::Json (LanguageServer::*)(const json::Json& params);
  static const std::map<std::string, Answer>& requests();
  static const std::map<std::string, void (LanguageServer::*)(const json::Json&)>& notifications();

  struct Message {
    std::string text;
    std::shared_ptr<void> held;
  };

  std::optional<Message> next_message();
  bool is_quiet();
  void handle(const std::string& text);
  void answer(const json::Json& id, const std::string& method, const json::Json& params);
  bool take_cancelled(const json::Json& id);
  void publish();
  void send(const json::Json& message);
  void send_error(const json::Json& id, int code, const std::string& message);

  json::Json initialize(const json::Json& params);
  json::Json shutdown(const json::Json& params);
  json::Json completion(const json::Json& params);
  json::Json hover(const json::Json& params);
  json::Json definition(const json::Json& params);
  json::Json references(const json::Json& params);
  json::Json prepare_rename(const json::Json& params);
  json::Json rename(const json::Json& params);
  json::Json document_symbols(const json::Json& params);
  json::Json code_actions(const json::Json& params);

  void did_open(const json::Json& params);
  void did_change(const json::Json& params);
  void did_close(const json::Json& params);
  void did_save(const json::Json& params);
  void exit(const json::Json& params);

  std::string file_of(const json::Json& params);
  json::Json edits_json(const FileEdits& edits);
  json::Json place_json(const EditorPlace& place);

  LanguageService service_;
  Send send_;
  FileUris uris_;
  std::map<std::string, json::Json> versions_;  ///< by open file
  bool initialized_ = false, shut_down_ = false, ended_ = false;

  std::mutex mutex_;  ///< protects the members below
  std::condition_variable arrived_;
  std::deque<Message> messages_;
  std::vector<std::string> cancelled_;  ///< ids as JSON text
  bool closed_ = false;
};

}  // namespace stepwire::language
