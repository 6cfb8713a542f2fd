#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/studio/http/gate.hpp"
#include "engine/base/io/descriptor.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire {

/// A connection to a port of this machine, byte by byte.
class RawClient {
 public:
  explicit RawClient(std::uint16_t port, bool v6 = false);

  bool is_connected() const { return socket_.open(); }
  void send(const std::string& bytes);
  /// Receives this number of bytes; fewer if the other side closes or is silent for five seconds.
  std::string receive(std::size_t bytes);
  /// All up to and with the mark.
  std::string receive_until(const std::string& mark);
  /// Until the other side closes.
  std::string receive_all();
  /// True if the other side closes within this time; the bytes until then are dropped.
  bool is_closed_within(std::chrono::milliseconds time);

 private:
  bool fill(std::chrono::milliseconds time);

  io::Descriptor socket_;
  std::string buffer_;
  bool closed_ = false;
};

/// The head of a request, whose every part may be wrong.
struct Head {
  std::string method = "GET", target = "/", host{}, more{};
  std::string text() const;
};

/// "Cookie: stepwire-8080=..." as a line of a head.
std::string cookie_line(const http::Key& key);
std::string host_of(const http::Key& key);
/// Header lines that request a WebSocket, without Origin and cookie.
extern const std::string upgrade_lines;

/// All that comes back to a request, after which the server is to close.
std::string answer_to(const http::Key& key, const Head& head);

/// A page's end of a socket.
class PageClient {
 public:
  explicit PageClient(const http::Key& key);

  bool is_open() const { return open_; }
  RawClient& raw() { return raw_; }
  /// A frame of one message; `kind` 1 is text, 2 bytes, 9 a ping.
  void send(const std::string& message, int kind = 1);
  /// Receives the next text or bytes, and answers pings. Returns std::nullopt if the server closes or is
  /// silent for five seconds.
  std::optional<std::string> receive();
  /// Calls, and waits for the answer; news before it are kept.
  json::Json call(const std::string& name, json::Json arguments = json::Json::object());
  /// The next news of this name.
  std::optional<json::Json> news(const std::string& name);

 private:
  RawClient raw_;
  bool open_ = false;
  int last_id_ = 0;
  std::vector<json::Json> kept_;
};

}  // namespace stepwire
