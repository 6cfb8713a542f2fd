#include "engine/app/cli/call_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>

#include "engine/base/text/characters.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::cli {
namespace {

const std::map<std::string, run::ExecutionMode> engines = {{"interpreted", run::ExecutionMode::interpreted},
                                                           {"compiled", run::ExecutionMode::compiled},
                                                           {"auto", run::ExecutionMode::automatic}};

const std::map<std::string, device::DeviceUse> devices = {
    {"cpu", device::DeviceUse::cpu}, {"gpu", device::DeviceUse::gpu}, {"auto", device::DeviceUse::automatic}};

}  // namespace

CLI::Validator choice(const std::vector<std::string>& words) {
  const auto problem = [words](std::string& word) -> std::string {
    if (std::ranges::find(words, word) != words.end()) return "";
    const std::string all = fmt::format("It takes: {}", fmt::join(words, ", "));
    return (fmt::format("does not take '{}'", word) + yaml::did_you_mean(word, words, all)).text();
  };
  return CLI::Validator(problem, CLI::IsMember(words).get_description());
}

std::vector<std::string> long_options(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options([](const CLI::Option*) { return true; }))
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::string fault_of_call(const CLI::App& program, const CLI::Error& error) {
  const auto verbs = program.get_subcommands();
  const CLI::App& called = verbs.empty() ? program : *verbs.front();
  const bool has_extras = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  for (const std::string& word : has_extras ? program.remaining(true) : std::vector<std::string>{}) {
    if (!word.starts_with("--")) continue;
    const std::string name = word.substr(0, word.find('='));
    const std::string form = verbs.empty() ? "stepwire" : "stepwire " + called.get_name();
    return text::visible((fmt::format("there is no option '{}'", name) +
                          yaml::did_you_mean(name, long_options(called), form + " --help lists them"))
                             .text());
  }
  return text::visible(error.what()) + "; stepwire --help and stepwire VERB --help tell more";
}

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

void add_device_option(CLI::App& verb, device::DeviceUse& device) {
  const auto number_of = [](std::string& word) -> std::string {
    const auto known = devices.find(word);
    if (known == devices.end()) return choice({"cpu", "gpu", "auto"})(word);
    word = std::to_string(static_cast<int>(known->second));
    return "";
  };
  CLI::Option* option =
      verb.add_option("--device", device, "where the points of a sweep run: cpu, gpu or auto");
  option->transform(CLI::Validator(number_of, "", "device"))->option_text("DEVICE");
}

std::vector<CLI::Option*> add_timing_options(CLI::App& verb, session::LoopWords& words) {
  return {verb.add_option("--rate", words.rate, "how often the thread wakes [Hz]")->capture_default_str(),
          verb.add_option("--policy", words.policy, "how it is scheduled: fifo:1 to fifo:99, or other")
              ->capture_default_str(),
          verb.add_option("--cpu", words.cpu, "the processor to which it is bound"),
          verb.add_option("--overrun", words.overrun,
                          "what a missed deadline means: skip drops it, catch-up runs it late, stop:N ends "
                          "the loop after N in a row")
              ->capture_default_str(),
          verb.add_option("--spin", words.spin, "time before each deadline at which it is awake, e.g. 200us")
              ->capture_default_str()};
}

}  // namespace stepwire::cli
