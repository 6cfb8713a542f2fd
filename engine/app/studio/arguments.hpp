#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/app/studio/fault.hpp"
#include "engine/app/studio/http/site.hpp"

namespace stepwire::studio {

/// Arguments of a call. Each function throws Fault if the argument is missing or has the wrong type.
class Arguments {
 public:
  explicit Arguments(const json::Json& message, http::Ticket ticket = {})
      : message_(message), ticket_(std::move(ticket)) {}

  /// Returns a whole number from 0 to 2^31 - 1.
  int whole(const std::string& name) const;
  std::string text(const std::string& name) const;
  bool flag(const std::string& name) const;
  std::vector<std::string> texts(const std::string& name) const;
  /// Returns the items of a list.
  std::span<const json::Json> items(const std::string& name) const;
  const json::Json& any(const std::string& name) const;
  const json::Json& all() const { return message_; }
  /// Returns the ticket of the message. Work that continues after the call has returned keeps a copy.
  const http::Ticket& ticket() const { return ticket_; }

 private:
  [[noreturn]] static void refuse(const std::string& name, const std::string& kind);

  const json::Json& message_;
  http::Ticket ticket_;
};

}  // namespace stepwire::studio
