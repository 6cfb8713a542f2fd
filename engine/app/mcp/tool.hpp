#pragma once

#include <string>
#include <vector>

#include "engine/app/reference/verb_words.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::mcp {

/// Argument of a tool: an option or a positional argument of its verb.
struct Argument {
  enum class Type { flag, number, whole, text, path };

  std::string key;     ///< in the JSON of a call: "set_from"
  std::string option;  ///< on the command line: "--set-from"; empty for a positional argument
  Type type = Type::text;
  std::string about;
  std::vector<std::string> choices;  ///< allowed values; empty if there is no closed list
  bool required = false, repeated = false;
};

/// Time when a verb gets --json: always, never, unless it writes to `out`, or if it explains a `name`.
enum class JsonForm { always, never, without_out, with_name };

/// Tool of the protocol: a verb of the command line.
struct Tool {
  std::string name, verb, about;
  std::string result;  ///< page of `stepwire format` with the fields of the result; empty without one
  JsonForm form = JsonForm::always;
  bool takes_text = false;  ///< a diagram may be given as `text` instead of a file
  bool gives_rows = false;  ///< recorded signals may be returned as a table
  std::vector<Argument> arguments;
};

/// Returns the tools that the declared verbs give. Options for terminals, for code from outside and for
/// several processes are left out.
std::vector<Tool> tools_of(const std::vector<reference::VerbWords>& verbs);

/// Returns the entry of `tools/list`: name, description, JSON schemas of arguments and result.
json::Json description_of(const Tool& tool);

}  // namespace stepwire::mcp
