#include "engine/app/cli/call_options.hpp"

#include <CLI/CLI.hpp>
#include <map>

#include "engine/app/cli/choice.hpp"

namespace stepwire::cli {

namespace {

const std::map<std::string, run::ExecutionMode> engines = {{"interpreted", run::ExecutionMode::interpreted},
                                                           {"compiled", run::ExecutionMode::compiled},
                                                           {"auto", run::ExecutionMode::automatic}};

}  // namespace

void add_engine_option(CLI::App& verb, run::ExecutionMode& engine, const std::string& what) {
  const auto number_of = [](std::string& word) -> std::string {
    const auto known = engines.find(word);
    if (known == engines.end()) return choice({"auto", "compiled", "interpreted"})(word);
    word = std::to_string(static_cast<int>(known->second));
    return "";
  };
  CLI::Option* option = verb.add_option("--engine", engine, what);
  option->transform(CLI::Validator(number_of, "", "engine"))->option_text("ENGINE");
}

}  // namespace stepwire::cli
