// Whether the pages and the program know the same options and keys.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/pages/command.hpp"
#include "tests/pages/page.hpp"
#include "tests/pages/workbench.hpp"

namespace {

using nlohmann::json;
using Words = std::set<std::string>;

std::string code_of_all_pages() {
  std::string code;
  for (const Page& page : all_pages()) code += all_code_of(page);
  return code;
}

Words options_of_program() {
  Words options = options_in(printed_by_program("--help"));
  for (const std::string& verb : verbs()) options.merge(options_in(help_of(verb)));
  return options;
}

/// Collects the keys of maps, and the words that are allowed as values.
void collect(const json& schema, Words& words) {
  if (schema.is_object()) {
    if (schema.contains("properties"))
      for (const auto& [key, value] : schema.at("properties").items()) words.insert(key);
    for (const char* name : {"const", "enum"})
      if (schema.contains(name))
        for (const json& word : schema.at(name).is_array() ? schema.at(name) : json{schema.at(name)})
          if (word.is_string()) words.insert(word.get<std::string>());
  }
  if (schema.is_structured())
    for (const json& part : schema) collect(part, words);
}

/// All keys and words of the format but those of the blocks, which `stepwire blocks` explains.
Words words_of_format() {
  json schema = json::parse(printed_by_program("schema"));
  Words blocks;
  for (const auto& [name, definition] : schema.at("$defs").items())
    if (name.starts_with("block.")) blocks.insert(name);
  for (const std::string& name : blocks) schema.at("$defs").erase(name);
  schema.at("$defs").erase("block");
  Words words;
  collect(schema, words);
  return words;
}

}  // namespace

TEST_CASE("every option of the program stands in a page") {
  const Words written = options_in(code_of_all_pages());
  for (const std::string& option : options_of_program()) {
    INFO(option);
    CHECK((written.contains(option) || option == "--help" || option == "--version"));
  }
}

TEST_CASE("every option that a page names alone is one of the program or of a script of ours") {
  Words known = options_of_program();
  for (const char* script : {"bench/run", "bench/fits", "bench/studio", "tests/random/run"})
    known.merge(options_in(content_of(std::filesystem::path(STEPWIRE_SOURCE_DIR) / script)));
  for (const Page& page : all_pages())
    for (const std::string& paragraph : paragraphs_of(page))
      for (const std::string& code : code_in(paragraph))
        if (code.starts_with("--")) {
          INFO(page.file << ": " << code);
          CHECK(known.contains(*options_in(code).begin()));
        }
}

TEST_CASE("every key and word of the format stands in a page") {
  const std::string code = code_of_all_pages();
  for (const std::string& word : words_of_format()) {
    INFO(word);
    CHECK(std::regex_search(code, std::regex("(^|[^A-Za-z0-9_])" + word + "($|[^A-Za-z0-9_])")));
  }
}
