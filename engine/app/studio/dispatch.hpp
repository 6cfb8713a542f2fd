#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "engine/app/studio/calls.hpp"
#include "engine/app/studio/http/site.hpp"
#include "engine/app/studio/lane.hpp"

namespace stepwire::studio {

/// Routes messages of pages to the calls that they name, each in the lane of its call, and sends the results
/// back. Within a lane, the calls of one page run in order, and pages take turns.
class Dispatch {
 public:
  using Send = std::function<void(int page, std::string text)>;
  using Acknowledge = std::function<void(int page, std::uint32_t sequence)>;

  Dispatch(const Calls& calls, Send send, Acknowledge acknowledge);

  /// Handles a message of a page; never throws, whatever the message contains.
  void take(int page, const std::string& message, const http::Ticket& ticket);
  /// Waits for the running calls and drops all waiting ones.
  void stop();

 private:
  void answer(int page, const CallRow& row, const Arguments& arguments) const;
  void refuse(int page, const json::Json& request) const;

  const Calls& calls_;
  Send send_;
  Acknowledge acknowledge_;
  std::map<CallRow::Where, Lane> lanes_;
};

/// Runs a call and returns the answer, with the `id` of the request. Without an `id` only faults are
/// answered; success returns std::nullopt.
std::optional<std::string> answer_to(const json::Json& request, const std::function<json::Json()>& call);

}  // namespace stepwire::studio
