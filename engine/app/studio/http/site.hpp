#pragma once

#include <memory>
#include <string>

#include "engine/app/studio/http/message.hpp"

namespace stepwire::http {

/// Token of a message in work. While a copy exists, the message counts against the limits of its page; beyond
/// them the server reads nothing further from the page.
using Ticket = std::shared_ptr<void>;

/// Interface of the content that a server serves. All calls come from the server's thread and should return
/// at once.
class Site {
 public:
  virtual ~Site() = default;
  /// Returns the answer to a GET or HEAD request that has passed the gate; it must change nothing.
  virtual Answer answer(const Request& request, const std::string& path) = 0;
  virtual bool has_socket(const std::string& path) = 0;
  /// Reports that a page has opened a socket. Numbers of pages count up from 1 and are not reused.
  virtual void joined(int page) = 0;
  virtual void said(int page, std::string message, Ticket ticket) = 0;
  virtual void left(int page) = 0;
};

}  // namespace stepwire::http
