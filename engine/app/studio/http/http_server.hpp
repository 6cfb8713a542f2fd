#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "engine/app/studio/http/gate.hpp"
#include "engine/app/studio/http/site.hpp"

namespace stepwire::http {

/// What the server takes from anyone.
struct Limits {
  std::uint32_t header = 8 << 10;  ///< [bytes] of the head of a request
  std::size_t message = 1 << 20;   ///< [bytes] of one message of a page
  // [bytes] for each page; beyond the first two no further message of the page is read, beyond the last the
  // page is closed
  std::size_t waiting = 2 << 20;              ///< messages of the page that are not done
  std::size_t unread = 4 << 20;               ///< messages to the page that it has not read
  std::size_t unsent = 64 << 20;              ///< the same
  std::size_t pages = 16;                     ///< sockets
  std::size_t connections = 64;               ///< with those that are no sockets
  std::chrono::milliseconds handshake{5000};  ///< for each request, and to become a socket
  std::chrono::milliseconds ping{20000};      ///< of silence, after which a page is looked for
};

/// HTTP/1.1 and WebSocket on the loopback addresses, behind the gate. One thread of its own.
class HttpServer {
 public:
  virtual ~HttpServer() = default;

  virtual const Key& key() const = 0;
  /// Begins to serve.
  virtual void start() = 0;
  /// Returns when the thread has ended and all pages have left. Sockets are closed when the server goes.
  virtual void stop() = 0;

  /// From any thread; nothing where the page has left.
  virtual void send_text(int page, std::string text) = 0;
  virtual void send_bytes(int page, std::string bytes) = 0;
};

/// Listens on 127.0.0.1 and, where there is one, on ::1, both at one port; 0 is any free one. The site must
/// outlive the server, and the server all tickets. Throws EnvironmentError with the system's reason.
std::unique_ptr<HttpServer> listen(Site& site, std::uint16_t port, const Limits& limits = {});

}  // namespace stepwire::http
