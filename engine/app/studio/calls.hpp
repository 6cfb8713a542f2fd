#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "engine/app/session/loaded_model.hpp"
#include "engine/app/studio/diagram_files.hpp"
#include "engine/app/studio/fault.hpp"
#include "engine/app/studio/http/site.hpp"

namespace stepwire::live {
class LiveRun;
struct Loading;
}  // namespace stepwire::live

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

class DrawingDesk;

/// Call that a page may make.
struct CallRow {
  /// Lane of a call. Calls of one page in one lane run in order; they never delay another lane.
  enum class Where {
    texts,  ///< edits and reads texts
    run,    ///< acts on the run without delay
    slow,   ///< takes long and changes nothing
  };

  /// Returns the result, or throws; `page` is the number of the calling page.
  std::function<json::Json(int page, const Arguments& arguments)> act;
  Where where = Where::texts;
};

/// Calls by name.
using Calls = std::map<std::string, CallRow>;

/// State that the calls share.
struct Desk {
  const Registry& registry;
  bool loop = false;  ///< true: runs are real-time loops
  std::mutex mutex;   ///< guards all members below except the last one, which is thread-safe
  DiagramFiles files;
  DraftStore store;
  /// Sends news to all pages except `but`; 0 excludes no page.
  std::function<void(const json::Json& news, int but)> tell;
};

/// Add the rows of their calls; the desk must outlive the calls.
void add_file_calls(Calls& calls, Desk& desk);
void add_state_calls(Calls& calls, Desk& desk);
void add_gallery_calls(Calls& calls, Desk& desk);
/// Adds the calls of the drawing; `drawing` must outlive the calls, too.
void add_drawing_calls(Calls& calls, Desk& desk, DrawingDesk& drawing);
/// Adds the calls of the run, which must outlive them.
void add_live_calls(Calls& calls, live::LiveRun& run);

/// Loads the model of a file from the edited texts of it and its parts. `hand`: with the pointer of a page as
/// input, if the scene has one. Throws as load_model() does.
live::Loading edited_model(Desk& desk, int file, bool hand);

/// Adds the edited documents of a file and of its parts to a loader; returns the path of the file.
std::string add_documents(Desk& desk, int file, diagram::Loader& loader);

/// Returns the news of a change on the disk: the edit that merges its lines into the draft, then the new
/// file.
std::vector<json::Json> change_news(int file, const WrittenElsewhere& written);

}  // namespace stepwire::studio
