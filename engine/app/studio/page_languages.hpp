#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>

#include "engine/app/studio/calls.hpp"

namespace stepwire::studio {

/// Language servers, one for each page, each in its own thread. A page names a file by its number:
/// "studio:/3".
class PageLanguages {
 public:
  using Send = std::function<void(int page, const json::Json& message)>;

  /// `send` is called from any thread. The desk must outlive this object.
  PageLanguages(Desk& desk, Send send);
  ~PageLanguages();

  void joined(int page);
  /// Posts a message to the server of a page; the first message starts the server. Does nothing after the
  /// page has left. The ticket is kept until the server has handled the message.
  void post(int page, const json::Json& message, http::Ticket ticket);
  /// Stops the server of a page; waits for the message that it is handling.
  void left(int page);

 private:
  class Server;

  Desk& desk_;
  Send send_;
  std::mutex mutex_;
  std::map<int, std::unique_ptr<Server>> servers_;
};

/// Adds the call `language`.
void add_language_calls(Calls& calls, PageLanguages& languages);

}  // namespace stepwire::studio
