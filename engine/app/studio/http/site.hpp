#pragma once

#include <memory>
#include <string>

#include "engine/app/studio/http/message.hpp"

namespace stepwire::http {

/// As long as a copy exists, the message that it came with counts against its page: a page is not read on
/// while too much of what it sent is not done.
using Ticket = std::shared_ptr<void>;

/// What is served. All calls come from the server's thread and should return at once.
class Site {
 public:
  virtual ~Site() = default;
  /// The answer to GET or HEAD, which change nothing, of a request that the gate has let pass.
  virtual Answer answer(const Request& request, const std::string& path) = 0;
  virtual bool has_socket(const std::string& path) = 0;
  /// A page has opened a socket; pages count up from 1 and never come again.
  virtual void joined(int page) = 0;
  virtual void said(int page, std::string message, Ticket ticket) = 0;
  virtual void left(int page) = 0;
};

}  // namespace stepwire::http
