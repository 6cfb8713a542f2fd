#include "engine/app/studio/page_languages.hpp"

#include <fmt/format.h>

#include <charconv>
#include <thread>
#include <utility>

#include "engine/app/language/language_server.hpp"

namespace stepwire::studio {

using json::Json;

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

void add_language_calls(Calls& calls, PageLanguages& languages) {
  calls["language"] = {[&languages](int page, const Arguments& arguments) {
    languages.post(page, arguments.any("message"), arguments.ticket());
    return Json::object();
  }};
}

}  // namespace stepwire::studio
