#include "engine/app/mcp/tool.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>

namespace stepwire::mcp {

using json::Json;
using reference::OptionWords;
using reference::VerbWords;

namespace {

/// Verb that is a tool. A tool with another name than its verb gives a part of the verb's result.
struct ToolRow {
  const char* name;
  const char* verb;
  const char* result;
  JsonForm form;
  const char* note;        ///< end of the description
  bool is_of_text = true;  ///< false: its file is no text
};

const std::vector<ToolRow>& rows() {
  static const std::vector<ToolRow> all{
      {"check", "check", "", JsonForm::always, "Returns all faults, each with its place and cure."},
      {"blocks", "blocks", "", JsonForm::with_name,
       "Without a name a list; a block's name gives its ports and parameters, another word the blocks about "
       "it."},
      {"format", "format", "", JsonForm::never,
       "Without a section a list; sections are head, parameters, record, claims, sweep, fit, results.run "
       "..."},
      {"draw", "draw", "", JsonForm::without_out, "Writes a picture to 'out', or returns blocks and wires."},
      {"run", "run", "results.run", JsonForm::always,
       "Returns verdicts and facts of the run; 'rows' returns recorded signals as well."},
      {"claims", "run", "results.claims", JsonForm::always, "Returns the verdicts alone."},
      {"diff", "diff", "results.diff", JsonForm::always, "Takes two files, or two texts."},
      {"fit", "fit", "results.fit", JsonForm::always, ""},
      {"tune", "tune", "results.tune", JsonForm::always, ""},
      {"linearize", "linearize", "results.linearize", JsonForm::always, ""},
      {"trim", "trim", "results.trim", JsonForm::always, ""},
      {"import", "import", "results.import", JsonForm::always,
       "Returns the written files, and a sentence on each block or value that has to be written or differs.",
       false}};
  return all;
}

bool is_left_out(const std::string& option) {
  // Terminals; pages for other programs; code from outside; processes; git; the names of own arguments.
  static const std::set<std::string> names{
      "--help",       "--json",   "--watch", "--quiet", "--color", "--markdown", "--table", "--python",
      "--typescript", "--blocks", "--parts", "--mpi",   "--part",  "--rev",      "--text",  "--csv"};
  return names.contains(option);
}

Argument::Type type_of(const OptionWords& words, const std::string& longest) {
  if (words.value.empty()) return Argument::Type::flag;
  const bool is_file = words.value == "FILE" || words.value == "DIR" || longest == "--out";
  if (is_file || longest.starts_with("FILE")) return Argument::Type::path;
  if (words.value == "FLOAT") return Argument::Type::number;
  return words.value == "INT" || words.value == "UINT" ? Argument::Type::whole : Argument::Type::text;
}

std::string key_of(std::string name) {
  name.erase(0, name.find_first_not_of('-'));
  std::ranges::transform(name, name.begin(),
                         [](unsigned char c) { return c == '-' ? '_' : static_cast<char>(std::tolower(c)); });
  return name;
}

Argument argument_of(const OptionWords& words, bool positional) {
  const std::string& longest = *std::ranges::max_element(words.names, {}, &std::string::size);
  return {key_of(longest),         positional ? "" : longest,
          type_of(words, longest), words.about,
          words.choices,           words.required,
          words.repeated};
}

Tool tool_of(const ToolRow& row, const VerbWords& verb) {
  Tool tool{row.name, row.verb, verb.about + ". " + row.note, row.result, row.form, false, false, {}};
  for (const OptionWords& words : verb.positionals) tool.arguments.push_back(argument_of(words, true));
  tool.takes_text = row.is_of_text && std::ranges::any_of(tool.arguments, [](const Argument& one) {
                      return one.type == Argument::Type::path;
                    });
  for (const OptionWords& words : verb.options) {
    const Argument argument = argument_of(words, false);
    if (argument.option == "--csv") tool.gives_rows = tool.name == tool.verb;
    if (!is_left_out(argument.option)) tool.arguments.push_back(argument);
  }
  return tool;
}

const char* json_type(Argument::Type type) {
  switch (type) {
    case Argument::Type::flag:
      return "boolean";
    case Argument::Type::number:
      return "number";
    case Argument::Type::whole:
      return "integer";
    default:
      return "string";
  }
}

Json schema_of(const Argument& argument) {
  Json schema = Json::object();
  const char* const type = json_type(argument.type);
  if (argument.repeated)
    schema.set("type", Json::list({type, "array"})).set("items", Json::object().set("type", type));
  else
    schema.set("type", type);
  if (!argument.choices.empty() && !argument.repeated) schema.set("enum", Json::list_of(argument.choices));
  const bool is_path = argument.type == Argument::Type::path;
  return schema.set("description", argument.about + (is_path ? "; a path relative to 'folder'" : ""));
}

Json typed(const char* type, const char* about) {
  return Json::object().set("type", type).set("description", about);
}

void add_own(Json& properties, const Tool& tool) {
  properties.set("folder", typed("string",
                                 "the folder of the call: files are read and written below it alone; "
                                 "without it a temporary one"));
  properties.set("limit", typed("number", "seconds after which the call is ended; 60 without it"));
  if (tool.takes_text) {
    const char* const about = "the text of the diagram in place of a file; of 'diff' a list of two texts";
    properties.set("text", Json::object()
                               .set("type", Json::list({"string", "array"}))
                               .set("items", Json::object().set("type", "string"))
                               .set("description", about));
  }
  if (tool.gives_rows)
    properties.set("rows", typed("integer", "return the recorded signals in at most so many rows"));
}

Json input_schema(const Tool& tool) {
  Json properties = Json::object(), required = Json::list();
  add_own(properties, tool);
  for (const Argument& argument : tool.arguments) {
    properties.set(argument.key, schema_of(argument));
    const bool has_text = tool.takes_text && argument.option.empty();
    if (argument.required && !has_text) required.push(argument.key);
  }
  return Json::object()
      .set("type", "object")
      .set("properties", std::move(properties))
      .set("required", std::move(required))
      .set("additionalProperties", false);
}

Json output_schema(const Tool& tool) {
  const std::string about =
      tool.result.empty()
          ? "data of the verb"
          : fmt::format("data of the verb; 'format' with section {} lists the fields", tool.result);
  Json properties = Json::object()
                        .set("exit", typed("integer",
                                           "0 done, 1 a verdict is negative, 2 a fault of the "
                                           "diagram or call, 3 of the surroundings"))
                        .set("meaning", typed("string", "the exit code in words"))
                        .set("result", Json::object().set("description", about))
                        .set("text", typed("string", "the page, of a verb without data"))
                        .set("signals", typed("object", "the recorded signals: columns, rows, of"))
                        .set("files", typed("array", "the files in 'out'"))
                        .set("notes", typed("array", "lines of faults and remarks"))
                        .set("shortened", typed("array", "what was left out to keep the answer small"));
  return Json::object()
      .set("type", "object")
      .set("properties", std::move(properties))
      .set("required", Json::list({"exit", "meaning"}));
}

}  // namespace

std::vector<Tool> tools_of(const std::vector<VerbWords>& verbs) {
  std::vector<Tool> tools;
  for (const ToolRow& row : rows())
    for (const VerbWords& verb : verbs)
      if (verb.name == row.verb) tools.push_back(tool_of(row, verb));
  return tools;
}

Json description_of(const Tool& tool) {
  return Json::object()
      .set("name", tool.name)
      .set("description", tool.about)
      .set("inputSchema", input_schema(tool))
      .set("outputSchema", output_schema(tool));
}

}  // namespace stepwire::mcp
