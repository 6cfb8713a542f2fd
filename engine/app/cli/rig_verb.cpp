#include <CLI/CLI.hpp>
#include <memory>

#include "engine/app/cli/call_options.hpp"
#include "engine/app/cli/model_call.hpp"
#include "engine/app/cli/real_time_call.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/base/unit/unit.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::cli {
namespace {

struct RigCall {
  session::LoopCall loop;
  LoadWords words;
  std::string shared, listen, to, latency = "0 s", inhibit = "100 ms";
  devices::PlantCall plant;
};

double time_of(const std::string& option, const std::string& text) {
  const auto quantity = unit::parse_quantity(text);
  const bool is_time =
      quantity && quantity->dimension && *quantity->dimension == unit::parse_unit("s")->dimension;
  if (is_time && quantity->value >= 0.0) return quantity->value;
  throw yaml::Error(yaml::Fault{{option + " " + text, {}}, "", "must be a time, such as '2 ms'", {}});
}

void choose_driver(RigCall& call) {
  if (call.shared.empty() == call.listen.empty())
    throw yaml::Error(
        yaml::Fault{{"rig", {}}, "", "is reached by one of --shared NAME and --listen PORT", {}});
  call.plant.driver = call.listen.empty() ? "shared" : "udp";
  if (call.listen.empty())
    call.plant.settings = {{"name", call.shared}};
  else
    call.plant.settings = {{"listen", call.listen}};
  if (!call.to.empty()) call.plant.settings.emplace_back("to", call.to);
}

void add_rig_options(CLI::App& verb, RigCall& call) {
  verb.add_option("FILE", call.loop.file, "a diagram whose inputs are commands and whose outputs are sensors")
      ->required();
  verb.add_option("--shared", call.shared, "name of the shared memory by which controllers reach it");
  verb.add_option("--listen", call.listen, "port, or address:port, at which it takes packets instead");
  verb.add_option("--to", call.to, "address:port to which it sends packets");
  verb.add_option("--latency", call.latency, "time by which sensors are seen later")->capture_default_str();
  verb.add_option("--inhibit", call.inhibit, "age of a command from which inputs have their defaults")
      ->capture_default_str();
  verb.add_option("--quantum", call.plant.quanta, "step of a sensor: angle=0.09deg; several times");
  verb.add_option("--noise", call.plant.noises,
                  "standard deviation of a sensor: force=0.015N; several times");
  verb.add_option("--seed", call.plant.seed, "of the noise")->capture_default_str();
  verb.add_option(
      "--fault", call.plant.faults,
      "stuck:force@2s, jump:angle=0.5rad@2s, nan:force@2s or unplug@2s; until an end with unplug@2s..2.02s; "
      "several times");
  verb.add_option("--duration", call.loop.words.duration, "for how long [s]")->capture_default_str();
  verb.add_option("--out", call.loop.out, "folder for signals.csv, inputs.csv, loop.json, loop.svg");
  add_timing_options(verb, call.loop.words);
  add_engine_option(verb, call.loop.engine, "interpreted, or compiled before the loop begins");
}

Action declare_rig(CLI::App& verb) {
  const auto call = std::make_shared<RigCall>();
  add_rig_options(verb, *call);
  add_load_options(verb, call->words);
  return [call](const Registry& registry) {
    call->loop.load = load_options(call->words);
    call->plant.latency = time_of("--latency", call->latency);
    call->plant.inhibit = time_of("--inhibit", call->inhibit);
    choose_driver(*call);
    call->loop.plant = call->plant;
    return run_in_real_time(call->loop, registry);
  };
}

}  // namespace

Verb rig_verb() {
  return {"rig", "run a plant by the clock as if it were hardware, for a controller in another process",
          "Example:\n  stepwire rig plant.yaml --shared rig --duration 60 --noise force=0.015N --fault "
          "stuck:force@20s",
          declare_rig};
}

}  // namespace stepwire::cli
