#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <set>

#include "engine/app/studio/http/http_server.hpp"
#include "tests/engine/app/studio/raw_client.hpp"

namespace stepwire::http {

/// Serves "/" and "/a.js", and a socket that gives every message back.
class EchoSite : public Site {
 public:
  Answer answer(const Request&, const std::string& path) override {
    if (path == "/") return {200, {{"Content-Type", "text/html"}}, "the page"};
    if (path == "/a.js") return {200, {}, "", "fixed"};
    return {404};
  }
  bool has_socket(const std::string& path) override { return path == "/socket"; }
  void joined(int page) override {
    change([&] { open.insert(page); });
  }
  void left(int page) override {
    change([&] { open.erase(page); });
  }
  void said(int page, std::string message, Ticket ticket) override {
    change([&] {
      bytes += message.size();
      if (keeps) tickets.push_back(std::move(ticket));
    });
    if (!keeps) server->send_text(page, std::move(message));
  }
  template <class Condition>
  bool wait_until(Condition condition) {
    std::unique_lock lock(mutex);
    return changed.wait_for(lock, std::chrono::seconds(5), condition);
  }

  HttpServer* server = nullptr;
  bool keeps = false;  ///< tickets; then nothing is given back
  std::mutex mutex;
  std::condition_variable changed;
  std::set<int> open;
  std::size_t bytes = 0;
  std::vector<Ticket> tickets;

 private:
  template <class Action>
  void change(Action action) {
    const std::lock_guard lock(mutex);
    action();
    changed.notify_all();
  }
};

/// A server that is gone after the test.
struct Served {
  explicit Served(Limits limits = {}) : server(listen(site, 0, limits)) {
    site.server = server.get();
    server->start();
  }
  ~Served() {
    server->stop();
    site.tickets.clear();
  }
  const Key& key() const { return server->key(); }
  Head head(const std::string& target, const std::string& more = {}) const {
    return {"GET", target, host_of(key()), cookie_line(key()) + more};
  }

  EchoSite site;
  std::unique_ptr<HttpServer> server;
};

}  // namespace stepwire::http
