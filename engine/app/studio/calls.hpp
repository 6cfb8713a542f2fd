#pragma once

#include <functional>
#include <map>
#include <string>

#include "engine/app/studio/arguments.hpp"
#include "engine/app/studio/diagram_files.hpp"

namespace stepwire::studio {

/// What a page may call, by its name. A call returns its result, or throws; `page` is who calls.
using Call = std::function<json::Json(int page, const Arguments& arguments)>;
using Calls = std::map<std::string, Call>;

/// What calls work on.
struct Desk {
  const Registry& registry;
  DiagramFiles files;
  DraftStore store;
  /// To all pages but one; 0 leaves none out.
  std::function<void(const json::Json& news, int but)> tell;
};

/// Each adds its rows; the desk must outlive them.
void add_file_calls(Calls& calls, Desk& desk);
void add_drawing_calls(Calls& calls, Desk& desk);
void add_state_calls(Calls& calls, Desk& desk);

/// News that a file is another on the disk; `draft` where a page has a text of its own.
json::Json change_news(int file, const EditedText& text);

}  // namespace stepwire::studio
