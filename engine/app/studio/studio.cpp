#include "engine/app/studio/studio.hpp"

#include <fmt/format.h>

#include <charconv>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

#include "engine/app/language/language_server.hpp"
#include "engine/app/studio/calls.hpp"
#include "engine/app/studio/dispatch.hpp"
#include "engine/app/studio/drawing_desk.hpp"
#include "engine/app/studio/live/live_run.hpp"
#include "engine/app/studio/page_site.hpp"

namespace stepwire::studio {

using json::Json;

/// Language servers, one for each page, each in its own thread. A page names a file by its number:
/// "studio:/3".
class PageLanguages {
 public:
  using Send = std::function<void(int page, const json::Json& message)>;

  /// `send` is called from any thread. The desk must outlive this object.
  PageLanguages(Desk& desk, Send send);
  ~PageLanguages();

  void joined(int page);
  /// Posts a message to the server of a page; the first message starts the server. Does nothing after the
  /// page has left. The ticket is kept until the server has handled the message.
  void post(int page, const json::Json& message, http::Ticket ticket);
  /// Stops the server of a page; waits for the message that it is handling.
  void left(int page);

 private:
  class Server;

  Desk& desk_;
  Send send_;
  std::mutex mutex_;
  std::map<int, std::unique_ptr<Server>> servers_;
};

namespace {

constexpr std::string_view scheme = "studio:/";

/// Returns the path of the file in a URI of a page; "" if the URI names no listed file.
std::string path_of(Desk& desk, const std::string& uri) {
  int number = -1;
  const char* const end = uri.data() + uri.size();
  if (!uri.starts_with(scheme) || std::from_chars(uri.data() + scheme.size(), end, number).ptr != end)
    return "";
  const std::lock_guard lock(desk.mutex);
  try {
    return desk.files.path(number);
  } catch (const Fault&) {
    return "";
  }
}

std::string uri_of(Desk& desk, const std::string& path) {
  const std::lock_guard lock(desk.mutex);
  return desk.files.beneath().holds(path) ? fmt::format("{}{}", scheme, desk.files.number(path)) : "";
}

language::FileUris uris(Desk& desk) {
  return language::FileUris([&desk](const std::string& uri) { return path_of(desk, uri); },
                            [&desk](const std::string& path) { return uri_of(desk, path); });
}

}  // namespace

/// Language server of one page.
class PageLanguages::Server {
 public:
  Server(Desk& desk, std::function<void(const Json&)> send)
      : server_(
            desk.registry,
            [send = std::move(send)](const std::string& message) { send(Json::parse(message)); }, uris(desk),
            desk.files.access()),
        thread_([this] { server_.run(); }) {}
  ~Server() {
    server_.abandon();
    thread_.join();
  }

  void post(std::string message, http::Ticket ticket) { server_.post(std::move(message), std::move(ticket)); }

 private:
  language::LanguageServer server_;
  std::thread thread_;
};

PageLanguages::PageLanguages(Desk& desk, Send send) : desk_(desk), send_(std::move(send)) {}

PageLanguages::~PageLanguages() = default;

void PageLanguages::joined(int page) {
  const std::lock_guard lock(mutex_);
  servers_[page];
}

void PageLanguages::post(int page, const Json& message, http::Ticket ticket) {
  const std::lock_guard lock(mutex_);
  const auto found = servers_.find(page);
  if (found == servers_.end()) return;
  std::unique_ptr<Server>& server = found->second;
  if (!server)
    server = std::make_unique<Server>(desk_, [this, page](const Json& answer) { send_(page, answer); });
  server->post(message.text(-1), std::move(ticket));
}

void PageLanguages::left(int page) {
  std::unique_ptr<Server> server;
  const std::lock_guard lock(mutex_);
  const auto found = servers_.find(page);
  if (found == servers_.end()) return;
  server = std::move(found->second);
  servers_.erase(found);
}

/// Adds the call `language`.
void add_language_calls(Calls& calls, PageLanguages& languages) {
  calls["language"] = {[&languages](int page, const Arguments& arguments) {
    languages.post(page, arguments.any("message"), arguments.ticket());
    return Json::object();
  }};
}

/// Site behind the sockets of the pages; owns all parts of the studio.
class Studio::Room : public http::Site {
 public:
  Room(const StudioCall& call, const Registry& registry)
      : desk_{registry,     call.loop.has_value(),
              {},           DiagramFiles(call.file),
              DraftStore(), [this](const Json& news, int but) { tell(news, but); }},
        server_(http::listen(*this, call.port, call.limits)),
        live_([this](int file, bool hand) { return edited_model(desk_, file, hand); },
              {[this](const Json& news) { tell(news, 0); },
               [this](int page, std::string bytes) { server_->send_bytes(page, std::move(bytes)); }},
              {call.loop, call.out}),
        languages_(desk_,
                   [this](int page, const Json& message) {
                     server_->send_text(
                         page, Json::object().set("news", "language").set("message", message).text(-1));
                   }),
        drawing_(desk_),
        calls_(calls_of()),
        dispatch_(
            calls_, [this](int page, std::string text) { server_->send_text(page, std::move(text)); },
            [this](int page, std::uint32_t sequence) { live_.acknowledge(page, sequence); }),
        watch_([this] { look_after(); }) {
    server_->start();
  }
  ~Room() override {
    server_->stop();
    dispatch_.stop();
    watch_.stop();
  }

  const http::Key& key() const { return server_->key(); }

  http::Answer answer(const http::Request& request, const std::string& path) override {
    return page_answer(page_table(), request, path);
  }
  bool has_socket(const std::string& path) override { return path == "/socket"; }
  void joined(int page) override {
    languages_.joined(page);
    const std::lock_guard lock(mutex_);
    pages_.insert(page);
  }
  void left(int page) override {
    {
      const std::lock_guard lock(mutex_);
      pages_.erase(page);
    }
    live_.left(page);
    watch_.post([this, page] { languages_.left(page); });  // posted, as it may take a while
  }
  void said(int page, std::string message, http::Ticket ticket) override {
    dispatch_.take(page, message, ticket);
  }

 private:
  Calls calls_of() {
    Calls calls;
    add_file_calls(calls, desk_);
    add_drawing_calls(calls, desk_, drawing_);
    add_language_calls(calls, languages_);
    add_state_calls(calls, desk_);
    add_gallery_calls(calls, desk_);
    add_live_calls(calls, live_);
    return calls;
  }

  void tell(const Json& news, int but) {
    const std::string text = news.text(-1);
    const std::lock_guard lock(mutex_);
    for (const int page : pages_)
      if (page != but) server_->send_text(page, text);
  }

  void look_after() {
    const std::lock_guard lock(desk_.mutex);
    desk_.files.texts().keep_drafts();
    desk_.files.texts().look_for_changes([this](const std::string& path, const WrittenElsewhere& written) {
      for (const json::Json& news : change_news(desk_.files.number(path), written)) tell(news, 0);
    });
  }

  Desk desk_;
  std::mutex mutex_;
  std::set<int> pages_;
  std::unique_ptr<http::HttpServer> server_;
  live::LiveRun live_;
  PageLanguages languages_;
  DrawingDesk drawing_;
  Calls calls_;
  Dispatch dispatch_;
  Lane watch_;  ///< stores drafts and checks the disk for changes
};

Studio::Studio(const StudioCall& call, const Registry& registry)
    : room_(std::make_unique<Room>(call, registry)) {}

Studio::~Studio() = default;

std::string Studio::address() const {
  return fmt::format("http://127.0.0.1:{}/?token={}", room_->key().port, room_->key().token);
}

}  // namespace stepwire::studio
