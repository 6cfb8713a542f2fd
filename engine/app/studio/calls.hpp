#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <string>

#include "engine/app/session/loaded_model.hpp"
#include "engine/app/studio/arguments.hpp"
#include "engine/app/studio/diagram_files.hpp"

namespace stepwire::live {
class LiveRun;
struct Loading;
}  // namespace stepwire::live

namespace stepwire::studio {

class DrawingDesk;

/// Something that a page may call.
struct CallRow {
  /// Calls of one page and lane are done in order, and hold up no other lane.
  enum class Where {
    texts,  ///< what edits and reads texts
    run,    ///< what must act on the run at once
    slow,   ///< what takes long and changes nothing
  };

  /// Returns the result, or throws; `page` is who calls.
  std::function<json::Json(int page, const Arguments& arguments)> act;
  Where where = Where::texts;
};

/// By their names.
using Calls = std::map<std::string, CallRow>;

/// What calls work on.
struct Desk {
  const Registry& registry;
  bool loop = false;  ///< runs are real-time loops
  std::mutex mutex;   ///< of all that follows but `tell`, which may be called from any thread
  DiagramFiles files;
  DraftStore store;
  /// To all pages but one; 0 leaves none out.
  std::function<void(const json::Json& news, int but)> tell;
};

/// Each adds its rows; the desk must outlive them.
void add_file_calls(Calls& calls, Desk& desk);
void add_state_calls(Calls& calls, Desk& desk);
void add_gallery_calls(Calls& calls, Desk& desk);
/// Of the drawing; `drawing` must outlive them, too.
void add_drawing_calls(Calls& calls, Desk& desk, DrawingDesk& drawing);
/// The calls of the run, which must outlive them.
void add_live_calls(Calls& calls, live::LiveRun& run);

/// The model of a file, as it and its parts are edited; `hand`: under the pointer of a page, where its scene
/// has one. Throws as load_model() does.
live::Loading edited_model(Desk& desk, int file, bool hand);

/// Gives a loader the documents of a file and of its parts, as they are edited; returns the file's path.
std::string add_documents(Desk& desk, int file, diagram::Loader& loader);

/// News that a file is another on the disk, behind that of the edit by which its lines came into the draft.
std::vector<json::Json> change_news(int file, const WrittenElsewhere& written);

}  // namespace stepwire::studio
