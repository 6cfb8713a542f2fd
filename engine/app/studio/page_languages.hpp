#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>

#include "engine/app/studio/calls.hpp"

namespace stepwire::studio {

/// A language server for each page, in a thread of its own. The page's name of a file is "studio:/3", by its
/// number.
class PageLanguages {
 public:
  using Send = std::function<void(int page, const json::Json& message)>;

  /// The desk must outlive this. `send` is called from any thread.
  PageLanguages(Desk& desk, Send send);
  ~PageLanguages();

  void joined(int page);
  /// Posts a message to the server of a page, which begins with the first one. Does nothing after the page
  /// has left. The ticket is kept until the server has handled the message.
  void post(int page, const json::Json& message, http::Ticket ticket);
  /// Ends the server of a page after the message that it handles; may take as long as that.
  void left(int page);

 private:
  class Server;

  Desk& desk_;
  Send send_;
  std::mutex mutex_;
  std::map<int, std::unique_ptr<Server>> servers_;
};

/// The call `language`.
void add_language_calls(Calls& calls, PageLanguages& languages);

}  // namespace stepwire::studio
