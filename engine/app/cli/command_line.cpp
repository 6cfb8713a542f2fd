#include "engine/app/cli/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/app/cli/call_options.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/cli/exit_code.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/session/version.hpp"
#include "engine/base/io/cache.hpp"
#include "engine/base/json/json.hpp"
#include "engine/base/subprocess/scratch_folder.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/yaml/error.hpp"
#include "engine/simulate/blockset/blockset.hpp"

namespace stepwire::cli {
namespace {

/// Option that names folders, for a program and all its verbs. Every verb that opens a diagram needs the
/// folders of blocks and of parts, so they are declared in one place.
class FolderOption {
 public:
  /// Adds the option to a program and to all its verbs.
  void add_to(CLI::App& app, const std::string& name, const std::string& about);
  /// Returns the named folders in order, without duplicates.
  std::vector<std::string> folders() const;

 private:
  std::vector<std::string> of_program_, of_verb_;  ///< before and after the verb
};

void add_option(CLI::App& app, const std::string& name, const std::string& about,
                std::vector<std::string>& folders) {
  app.add_option(name, folders, about)->type_name("DIR")->allow_extra_args(false);
}

/// Throws Error for a path in which no parts can be looked for.
void require_part_folder(const std::string& folder) {
  const auto refuse = [&](const char* message) {
    throw yaml::Error(yaml::Fault{{"--parts " + folder, {}}, "", message, {}});
  };
  std::error_code none;
  if (!std::filesystem::is_directory(folder, none)) refuse("no such folder");
  if (folder.find(':') != std::string::npos)
    refuse("a folder of parts has no ':' in its path, which separates those of STEPWIRE_PARTS; rename it");
}

void FolderOption::add_to(CLI::App& app, const std::string& name, const std::string& about) {
  add_option(app, name, about, of_program_);
  for (CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
    add_option(*verb, name, about, of_verb_);
}

std::vector<std::string> FolderOption::folders() const {
  std::vector<std::string> result;
  std::set<std::filesystem::path> known;
  for (const auto* folders : {&of_program_, &of_verb_})
    for (const std::string& folder : *folders)
      if (known.insert(std::filesystem::weakly_canonical(folder)).second) result.push_back(folder);
  return result;
}

/// Puts folders in front of those of STEPWIRE_PARTS, which child processes inherit. Throws Error for a
/// path that is no folder or contains ':'.
void look_for_parts(const std::vector<std::string>& folders) {
  if (folders.empty()) return;
  for (const std::string& folder : folders) require_part_folder(folder);
  const char* known = std::getenv("STEPWIRE_PARTS");
  std::string all = fmt::format("{}", fmt::join(folders, ":"));
  if (known && *known) all += std::string(":") + known;
  ::setenv("STEPWIRE_PARTS", all.c_str(), 1);
}

const std::map<std::string, Color> colors{
    {"auto", Color::automatic}, {"always", Color::always}, {"never", Color::never}};

void add_options(CLI::App& app) {
  app.add_flag_callback(
      "--quiet", [] { console_style().quiet = true; }, "print errors, failures and data alone");
  app.add_option_function<std::string>(
         "--color", [](const std::string& word) { console_style().color = colors.at(word); },
         "colours; auto: on a terminal, unless NO_COLOR is set")
      ->check(choice({"auto", "always", "never"}));
}

/// Declares --quiet and --color for the program and all its verbs.
void add_console_options(CLI::App& program) {
  add_options(program);
  for (CLI::App* verb : program.get_subcommands([](const CLI::App*) { return true; })) add_options(*verb);
}

constexpr const char* no_value = "has no value";

/// Parser of all verbs.
class CommandLine {
 public:
  CommandLine() {
    app_.require_subcommand(1);
    app_.failure_message([](const CLI::App* program, const CLI::Error& error) {
      return fmt::format("stepwire: {}\n", fault_of_call(*program, error));
    });
    app_.set_version_flag(
            "--version", [this] { return version(); }, "print the version; with --json also what compiled it")
        ->group("Options");
    for (const Verb& verb : verbs()) {
      CLI::App* words = app_.add_subcommand(verb.name, verb.about);
      words->footer(verb.footer);
      words->callback([this, action = verb.declare(*words)] { action_ = action; });
    }
    blocks_.add_to(app_, "--blocks", "a folder with further blocks, as C++; may be given several times");
    parts_.add_to(app_, "--parts", "a folder in which parts are looked for, before those of STEPWIRE_PARTS");
    add_console_options(app_);
    refuse_empty_values(app_);
    for (CLI::App* verb : app_.get_subcommands([](const CLI::App*) { return true; }))
      refuse_empty_values(*verb);
  }

  ExitCode run(int argc, char** argv, Registry registry) {
    if (argc > 1 && *argv[1] != '-' && !is_verb(argv[1])) return refuse_verb(argv[1]);
    try {
      json_ =
          std::ranges::count(std::span(argv, static_cast<std::size_t>(argc)), std::string_view("--json")) > 0;
      require_values(argc, argv);
      app_.parse(argc, argv);
      const ExitCode loaded = load_folders(registry);
      return loaded == ExitCode::done ? action_(registry) : loaded;
    } catch (const CLI::ParseError& error) {
      return explain(error);
    }
  }

 private:
  /// Refuses options that end in '=': CLI11 would take the next word as the value.
  static void require_values(int argc, char** argv) {
    for (const std::string_view word : std::span(argv, static_cast<std::size_t>(argc)))
      if (word.starts_with("--") && word.find('=') == word.size() - 1)
        throw CLI::ValidationError(std::string(word), no_value);
  }

  std::string version() const {
    if (!json_) return "stepwire " + session::program_version();
    return json::Json::object()
        .set("version", session::program_version())
        .set("compiler", session::compiler_version())
        .text();
  }

  static void refuse_empty_values(CLI::App& app) {
    const CLI::Validator is_filled([](const std::string& it) { return it.empty() ? no_value : ""; }, "");
    for (CLI::Option* option :
         app.get_options([](const CLI::Option* it) { return it->get_items_expected_max() > 0; }))
      option->check(is_filled);
  }

  /// Loads the folders of blocks and of parts, which every verb knows. Code comes from folders that the call
  /// or its environment names alone, never from those of a diagram file.
  ExitCode load_folders(Registry& registry) const {
    ExitCode code = load("--parts", [&] { look_for_parts(parts_.folders()); });
    if (code == ExitCode::done)
      code = load("STEPWIRE_BLOCKS", [&] { blockset::load_blocksets_of_environment(registry); });
    for (const std::string& folder : blocks_.folders())
      if (code == ExitCode::done)
        code = load("--blocks " + folder, [&] { blockset::load_blockset(folder, registry); });
    return code;
  }

  /// Loads folders. Their faults are printed as JSON if the verb prints JSON.
  ExitCode load(const std::string& call, const std::function<void()>& folders) const {
    json::Json faults;
    const auto loaded = [&] {
      folders();
      return ExitCode::done;
    };
    const ExitCode code = guarded(loaded, &faults);
    const CLI::App* verb = app_.get_subcommands().front();
    const CLI::Option* json = verb->get_option_no_throw("--json");
    if (faults.is_list() && json && json->count() > 0)
      put_json(json::Json::list({json::Json::object().set("call", call).set("faults", std::move(faults))}));
    return code;
  }

  /// Prints the help of --help, or the faults of the call.
  ExitCode explain(const CLI::ParseError& error) const {
    std::ostringstream help, wrong;
    const int code = app_.exit(error, help, wrong);
    put_data(help.str());
    put_trouble(wrong.str());
    return code == 0 ? ExitCode::done : ExitCode::wrong;
  }

  static bool is_verb(const std::string& word) {
    return std::ranges::any_of(verbs(), [&](const Verb& verb) { return word == verb.name; });
  }

  static ExitCode refuse_verb(const std::string& word) {
    std::vector<std::string> names;
    for (const Verb& verb : verbs()) names.emplace_back(verb.name);
    complain("stepwire: there is no '{}'{}\n", text::visible(word),
             yaml::did_you_mean(word, names, fmt::format("There are: {}", fmt::join(names, ", "))).text());
    return ExitCode::wrong;
  }

  CLI::App app_{"Block diagrams in text, run at a fixed step."};
  FolderOption blocks_, parts_;
  Action action_;
  bool json_ = false;  ///< true if the call contains `--json`
};

}  // namespace

int run_command_line(int argc, char** argv, Registry (*blocks)()) {
  fill_standard_streams();
  catch_signals();
  subprocess::remove_abandoned_folders();
  const ExitCode code = guarded([&] { return CommandLine().run(argc, argv, blocks()); });
  if (const std::string problem = io::take_cache_problem(); !problem.empty())
    remark("the cache keeps nothing: {}\n", text::visible(problem));
  return static_cast<int>(finish_output() ? code : worst(code, ExitCode::surroundings));
}

}  // namespace stepwire::cli
