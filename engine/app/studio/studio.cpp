#include "engine/app/studio/studio.hpp"

#include <fmt/format.h>

#include <mutex>
#include <set>
#include <utility>

#include "engine/app/studio/calls.hpp"
#include "engine/app/studio/lane.hpp"
#include "engine/app/studio/page_site.hpp"

namespace stepwire::studio {

using json::Json;

/// What the sockets of the pages lead to.
class Studio::Room : public http::Site {
 public:
  Room(const StudioCall& call, const Registry& registry)
      : desk_{registry, DiagramFiles(call.file), DraftStore(),
              [this](const Json& news, int but) { tell(news, but); }},
        server_(*this, call.port, call.limits),
        lane_([this] { tick(); }) {
    add_file_calls(calls_, desk_);
    add_drawing_calls(calls_, desk_);
    add_state_calls(calls_, desk_);
    server_.start();
  }
  ~Room() override {
    server_.stop();
    lane_.stop();
  }

  const http::Key& key() const { return server_.key(); }

  http::Answer answer(const http::Request& request, const std::string& path) override {
    return page_answer(page_table(), request, path);
  }
  bool has_socket(const std::string& path) override { return path == "/socket"; }
  void joined(int page) override {
    const std::lock_guard lock(mutex_);
    pages_.insert(page);
  }
  void left(int page) override {
    const std::lock_guard lock(mutex_);
    pages_.erase(page);
  }
  void said(int page, std::string message, http::Ticket ticket) override {
    lane_.post([this, page, message = std::move(message), ticket = std::move(ticket)] {
      const std::string answer = answer_to(page, message);
      if (!answer.empty()) server_.send_text(page, answer);
    });
  }

 private:
  std::string answer_to(int page, const std::string& message) {
    Json answer = Json::object();
    try {
      const Json request = Json::parse(message);
      if (const Json* id = request.find("id"); id && id->as_number()) answer.set("id", *id);
      answer.set("result", result_of(page, request));
    } catch (...) {
      answer.set("fault", fault_in_flight());
    }
    return answer.text(-1);
  }

  Json result_of(int page, const Json& request) {
    const std::string name = Arguments(request).text("call");
    const auto call = calls_.find(name);
    if (call == calls_.end()) throw Fault(fmt::format("there is no call '{}'", name));
    return call->second(page, Arguments(request));
  }

  void tell(const Json& news, int but) {
    const std::string text = news.text(-1);
    const std::lock_guard lock(mutex_);
    for (const int page : pages_)
      if (page != but) server_.send_text(page, text);
  }

  void tick() {
    desk_.files.texts().keep_drafts();
    desk_.files.texts().look_for_changes([this](const std::string& path, const EditedText& text) {
      tell(change_news(desk_.files.number(path), text), 0);
    });
  }

  Desk desk_;
  Calls calls_;
  std::mutex mutex_;
  std::set<int> pages_;
  http::HttpServer server_;
  Lane lane_;
};

Studio::Studio(const StudioCall& call, const Registry& registry)
    : room_(std::make_unique<Room>(call, registry)) {}

Studio::~Studio() = default;

std::string Studio::address() const {
  return fmt::format("http://127.0.0.1:{}/?token={}", room_->key().port, room_->key().token);
}

}  // namespace stepwire::studio
