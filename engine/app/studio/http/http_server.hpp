#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "engine/app/studio/http/gate.hpp"

namespace stepwire::http {

/// As long as a copy exists, the message that it came with counts against its page: a page is not read on
/// while too much of what it sent waits.
using Ticket = std::shared_ptr<void>;

/// What is served. All calls come from the server's thread and should return at once.
class Site {
 public:
  virtual ~Site() = default;
  /// The answer to a request that the gate has let pass.
  virtual Answer answer(const Request& request, const std::string& path) = 0;
  virtual bool has_socket(const std::string& path) = 0;
  /// A page has opened a socket; pages count up from 1 and never come again.
  virtual void joined(int page) = 0;
  virtual void said(int page, std::string message, Ticket ticket) = 0;
  virtual void left(int page) = 0;
};

/// What the server takes from anyone.
struct Limits {
  std::uint32_t header = 8 << 10;  ///< [bytes] of the head of a request
  std::size_t message = 1 << 20;   ///< [bytes] of one message of a page
  std::size_t waiting = 2 << 20;   ///< [bytes] of messages that wait for one page
  std::size_t unsent = 64 << 20;   ///< [bytes] for a page that does not read; beyond it the socket is closed
  std::size_t pages = 16;          ///< sockets
  std::size_t connections = 64;    ///< with those that are no sockets
  std::chrono::milliseconds handshake{5000};  ///< for each request, and to become a socket
  std::chrono::milliseconds ping{20000};      ///< of silence, after which a page is looked for
};

/// HTTP/1.1 and WebSocket on the loopback addresses, behind the gate. One thread of its own.
class HttpServer {
 public:
  /// Listens on 127.0.0.1 and, where there is one, on ::1, both at one port; 0 is any free one. Throws
  /// EnvironmentError with the system's reason.
  HttpServer(Site& site, std::uint16_t port, Limits limits = {});
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  const Key& key() const;
  /// Begins to serve.
  void start();
  /// Closes all sockets, and returns when the thread has ended.
  void stop();

  /// From any thread; nothing where the page has left.
  void send_text(int page, std::string text);
  void send_bytes(int page, std::string bytes);

 private:
  class Service;
  std::unique_ptr<Service> service_;
};

}  // namespace stepwire::http
