#include "engine/app/studio/studio.hpp"

#include <fmt/format.h>

#include <mutex>
#include <set>
#include <utility>

#include "engine/app/studio/calls.hpp"
#include "engine/app/studio/dispatch.hpp"
#include "engine/app/studio/drawing_desk.hpp"
#include "engine/app/studio/live/live_run.hpp"
#include "engine/app/studio/page_languages.hpp"
#include "engine/app/studio/page_site.hpp"

namespace stepwire::studio {

using json::Json;

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
