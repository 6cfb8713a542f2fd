#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "engine/app/studio/calls.hpp"
#include "engine/app/studio/http/site.hpp"
#include "engine/app/studio/lane.hpp"

namespace stepwire::studio {

/// Leads the messages of pages to the calls that they name, each in the lane of its call, and their results
/// back. In a lane the calls of one page are done in order, and pages take turns.
class Dispatch {
 public:
  using Send = std::function<void(int page, std::string text)>;
  using Acknowledge = std::function<void(int page, std::uint32_t sequence)>;

  Dispatch(const Calls& calls, Send send, Acknowledge acknowledge);

  /// Throws nothing, whatever the message is.
  void take(int page, const std::string& message, const http::Ticket& ticket);
  /// What goes on comes to its end.
  void stop();

 private:
  void answer(int page, const CallRow& row, const Arguments& arguments) const;
  void refuse(int page, const json::Json& request) const;

  const Calls& calls_;
  Send send_;
  Acknowledge acknowledge_;
  std::map<CallRow::Where, Lane> lanes_;
};

/// The message of the page that an answer belongs to has an `id`; nothing is answered where there is none.
std::optional<std::string> answer_to(const json::Json& request, const std::function<json::Json()>& call);

}  // namespace stepwire::studio
