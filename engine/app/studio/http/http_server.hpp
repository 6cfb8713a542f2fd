#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "engine/app/studio/http/gate.hpp"
#include "engine/app/studio/http/site.hpp"

namespace stepwire::http {

/// Limits of a server.
struct Limits {
  std::uint32_t header = 8 << 10;  ///< [bytes] head of a request
  std::size_t message = 1 << 20;   ///< [bytes] message of a page
  // Limits of each page [bytes]. Reading stops beyond the first two; beyond the last the page is closed.
  std::size_t waiting = 2 << 20;  ///< unhandled messages from the page
  std::size_t unread = 4 << 20;   ///< messages to the page that it has not read
  std::size_t unsent = 64 << 20;  ///< same as `unread`
  std::size_t pages = 16;
  std::size_t connections = 64;               ///< connections, WebSockets included
  std::chrono::milliseconds handshake{5000};  ///< time for each request and for opening a WebSocket
  std::chrono::milliseconds ping{20000};      ///< silence after which the server pings a page
};

/// Server for HTTP/1.1 and WebSocket on the loopback addresses, behind the gate. It has one thread.
class HttpServer {
 public:
  virtual ~HttpServer() = default;

  virtual const Key& key() const = 0;
  /// Starts serving.
  virtual void start() = 0;
  /// Stops the thread and reports all pages as left. The destructor closes the sockets.
  virtual void stop() = 0;

  /// Sends a message to a page; thread-safe. Does nothing if the page has left.
  virtual void send_text(int page, std::string text) = 0;
  virtual void send_bytes(int page, std::string bytes) = 0;
};

/// Listens on 127.0.0.1 and, if available, on ::1, at the same port; 0 means any free port. The site must
/// outlive the server, and the server all tickets. Throws EnvironmentError with the system's reason.
std::unique_ptr<HttpServer> listen(Site& site, std::uint16_t port, const Limits& limits = {});

}  // namespace stepwire::http
