#include "tests/pages/command.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <sstream>

#include "tests/pages/workbench.hpp"

namespace {

namespace fs = std::filesystem;

const fs::path top = STEPWIRE_SOURCE_DIR;
const std::string own = "./stepwire";

std::vector<std::string> words_of(const std::string& command) {
  std::vector<std::string> words;
  std::istringstream stream(command.substr(0, command.find(" #")));
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

bool has(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// True if a command has a placeholder, such as FILE, DIR or NAME.
bool has_placeholder(const std::string& command) {
  return std::regex_search(command, std::regex(R"((^|[ =])[A-Z][A-Z_]+\b)"));
}

/// True if the words are a command of the wrapper script, which is no verb of the program and takes minutes.
bool is_of_wrapper(const std::vector<std::string>& words) {
  return has(words, "test") || has(words, "install") || has(words, "package") || has(words, "setup") ||
         has(words, "python");
}

/// True if a command takes minutes, or runs until it is interrupted.
bool goes_on(const std::vector<std::string>& words) {
  const bool whole_study = has(words, "study") && std::ranges::any_of(words, [](const std::string& word) {
                             return word.starts_with("diagrams/thesis/");
                           });
  const bool serves = has(words, "studio") || has(words, "lsp") || has(words, "--watch");
  return is_of_wrapper(words) || (has(words, "thesis") && !has(words, "--only")) || whole_study || serves;
}

std::string fault_of_own(const std::vector<std::string>& words, const std::string& command) {
  if (words.size() < 2 || is_of_wrapper({words[1]}) || has_placeholder(words[1]) ||
      words[1].starts_with("--"))
    return "";
  if (std::find(verbs().begin(), verbs().end(), words[1]) == verbs().end()) return "no verb " + words[1];
  const std::set<std::string> known = options_in(help_of(words[1]));
  for (const std::string& option : options_in(command))
    if (!known.contains(option)) return words[1] + " has no option " + option;
  return "";
}

/// Targets of CMake are programs of their own, and test_ with the name of a folder of tests.
bool is_target(const std::string& name) {
  if (name == "all" || name == "stepwire" || name == "stepwire_python") return true;
  std::string folder = name.starts_with("test_") ? name.substr(5) : name;
  std::replace(folder.begin(), folder.end(), '_', '/');
  if (folder != name && fs::is_directory(top / "tests" / folder)) return true;
  for (const char* list : {"bench/CMakeLists.txt", "tests/CMakeLists.txt", "tests/fuzz/CMakeLists.txt"})
    if (std::regex_search(content_of(top / list), std::regex("add_executable\\(" + name + "\\b")))
      return true;
  return false;
}

bool is_preset(const std::string& name) {
  return content_of(top / "CMakePresets.json").find("\"name\": \"" + name + "\"") != std::string::npos;
}

std::string behind(const std::vector<std::string>& words, const std::string& word) {
  const auto at = std::find(words.begin(), words.end(), word);
  return at == words.end() || at + 1 == words.end() ? "" : *(at + 1);
}

std::string fault_of_others(const std::vector<std::string>& words) {
  if (words[0].starts_with("build/")) {
    const std::string name = fs::path(words[0]).filename().string();
    if (!is_target(name)) return "no target " + name;
  } else if (words[0].find('/') != std::string::npos && !fs::exists(top / words[0])) {
    return "no file " + words[0];
  }
  for (const char* word : {"--target", "-t"})
    if (const std::string name = behind(words, word); !name.empty() && !is_target(name))
      return "no target " + name;
  if (const std::string name = behind(words, "--preset"); !name.empty() && !is_preset(name))
    return "no preset " + name;
  if (const std::string folder = behind(words, "--prefix"); !folder.empty() && !fs::exists(top / folder))
    return "no folder " + folder;
  return "";
}

}  // namespace

bool is_command(const std::string& code) {
  return std::regex_search(
             code,
             std::regex(
                 R"(^(\./stepwire|bench/run|bench/fits|tests/\S+|build/\S+|cmake|ctest|npm|git) ?(?! ))")) &&
         code.find(' ') != std::string::npos;
}

bool is_run(const std::string& command) {
  return command.starts_with(own + " ") && !has_placeholder(command) && !goes_on(words_of(command));
}

std::string fault_of(const std::string& command) {
  const std::vector<std::string> words = words_of(command);
  return words[0] == own ? fault_of_own(words, command) : fault_of_others(words);
}

std::set<std::string> options_in(const std::string& text) {
  std::set<std::string> options;
  const std::regex option(R"((^|[\s,\[|`(])(--[a-z][a-z-]*))");
  for (std::sregex_iterator at(text.begin(), text.end(), option), none; at != none; ++at)
    options.insert(at->str(2));
  return options;
}

const std::vector<std::string>& verbs() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> found;
    const std::string help = printed_by_program("--help");
    const std::string list = help.substr(help.find("Subcommands:"));
    const std::regex verb(R"(\n  ([a-z][a-z-]*) )");
    for (std::sregex_iterator at(list.begin(), list.end(), verb), none; at != none; ++at)
      found.push_back(at->str(1));
    return found;
  }();
  return all;
}

const std::string& help_of(const std::string& verb) {
  static std::map<std::string, std::string> known;
  const auto [at, is_new] = known.emplace(verb, "");
  if (is_new) at->second = printed_by_program(verb + " --help");
  return at->second;
}
