#include "engine/app/mcp/tool_arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/text/characters.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::mcp {

using json::Json;

namespace {

constexpr double longest_limit = 3600.0;  // [s]
constexpr double most_rows = 2000.0;

[[noreturn]] void refuse(const std::string& key, const std::string& why) {
  throw CallFault(fmt::format("{}: {}", key, why));
}

void require_known(const Tool& tool, const Json& arguments) {
  std::vector<std::string> names{"folder", "limit"};
  if (tool.takes_text) names.emplace_back("text");
  if (tool.gives_rows) names.emplace_back("rows");
  for (const Argument& argument : tool.arguments) names.push_back(argument.key);
  for (const auto& [key, value] : arguments.members()) {
    if (std::ranges::find(names, key) != names.end()) continue;
    const std::string all = fmt::format("There are: {}", fmt::join(names, ", "));
    throw CallFault(fmt::format("there is no argument '{}'{}", text::visible(key),
                                yaml::did_you_mean(key, names, all).text()));
  }
}

double number_of(const Json& arguments, const char* key, double usual, double least, double most) {
  const Json* const given = arguments.find(key);
  if (!given || given->is_null()) return usual;
  const auto number = given->as_number();
  if (!number || !(*number >= least && *number <= most))
    refuse(key, fmt::format("is a number from {} to {}", least, most));
  return *number;
}

/// Returns one value as text.
std::string word_of(const Argument& argument, const Json& value, const ToolFolder& folder) {
  const std::string* const text = value.as_text();
  if (value.is_list() || value.is_object() || value.is_null() || value.as_flag())
    refuse(argument.key, "is a text or number");
  if (text && text->find('\0') != std::string::npos) refuse(argument.key, "has a character of code 0");
  if (text && text->empty()) refuse(argument.key, "is empty; leave it out");
  if (argument.type == Argument::Type::path) {
    if (!text) refuse(argument.key, "is a path, as text");
    return folder.checked(*text);
  }
  if (argument.type == Argument::Type::whole && !text && std::fmod(*value.as_number(), 1.0) != 0.0)
    refuse(argument.key, "is a whole number");
  return text ? *text : value.text(-1);
}

std::vector<std::string> words_of(const Argument& argument, const Json& value, const ToolFolder& folder) {
  if (!value.is_list()) return {word_of(argument, value, folder)};
  if (!argument.repeated) refuse(argument.key, "is a single value, not a list");
  std::vector<std::string> words;
  for (const Json& one : value.items()) words.push_back(word_of(argument, one, folder));
  return words;
}

void add_option(const Argument& argument, const Json& value, const ToolFolder& folder, VerbCall& call) {
  if (argument.type == Argument::Type::flag) {
    const auto flag = value.as_flag();
    if (!flag) refuse(argument.key, "is true or false");
    if (*flag) call.words.push_back(argument.option);
    return;
  }
  for (const std::string& word : words_of(argument, value, folder)) {
    call.words.push_back(argument.option + "=" + word);
    if (argument.key == "out") call.out = word;
  }
}

/// Appends the texts of the call as files; false without texts.
bool add_texts(const Tool& tool, const Json& arguments, ToolFolder& folder, VerbCall& call) {
  const Json* const given = tool.takes_text ? arguments.find("text") : nullptr;
  if (!given || given->is_null()) return false;
  const auto add = [&](const Json& text) {
    if (!text.as_text()) refuse("text", "is the text of a diagram, or a list of two");
    call.words.push_back(folder.add_text(*text.as_text()));
  };
  if (!given->is_list()) add(*given);
  for (const Json& text : given->items()) add(text);
  return true;
}

void add_positionals(const Tool& tool, const Json& arguments, ToolFolder& folder, VerbCall& call) {
  const bool has_texts = add_texts(tool, arguments, folder, call);
  for (const Argument& argument : tool.arguments) {
    if (!argument.option.empty()) continue;
    const Json* const value = arguments.find(argument.key);
    const bool given = value && !value->is_null();
    if (given && has_texts) refuse(argument.key, "is not given beside 'text'");
    if (!given && !has_texts && argument.required)
      refuse(argument.key,
             tool.takes_text ? "is missing; name a file below 'folder', or give its 'text'" : "is missing");
    if (!given) continue;
    for (const std::string& word : words_of(argument, *value, folder)) {
      if (word.front() == '-') refuse(argument.key, "begins with '-'");
      call.words.push_back(word);
    }
  }
}

bool wants_json(const Tool& tool, const Json& arguments) {
  const auto has = [&](const char* key) { return arguments.find(key) && !arguments.find(key)->is_null(); };
  return tool.form == JsonForm::always || (tool.form == JsonForm::without_out && !has("out")) ||
         (tool.form == JsonForm::with_name && has("name"));
}

}  // namespace

VerbCall verb_call(const Tool& tool, const Json& arguments, ToolFolder& folder) {
  if (!arguments.is_object()) throw CallFault("arguments are an object");
  require_known(tool, arguments);
  VerbCall call;
  call.words.push_back(tool.verb);
  const double limit = number_of(arguments, "limit", 60.0, 0.001, longest_limit);
  call.limit = std::chrono::milliseconds(static_cast<std::int64_t>(1000.0 * limit));
  call.rows = static_cast<std::size_t>(number_of(arguments, "rows", 0.0, 0.0, most_rows));
  add_positionals(tool, arguments, folder, call);
  for (const Argument& argument : tool.arguments)
    if (const Json* value = arguments.find(argument.key);
        value && !value->is_null() && !argument.option.empty())
      add_option(argument, *value, folder, call);
  if (wants_json(tool, arguments)) call.words.emplace_back("--json");
  if (tool.gives_rows && call.rows > 0) call.words.push_back("--csv=" + folder.scratch() + "/signals.csv");
  return call;
}

}  // namespace stepwire::mcp
