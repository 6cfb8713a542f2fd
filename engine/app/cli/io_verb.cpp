#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <thread>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/yaml/error.hpp"
#include "engine/simulate/devices/wired_device.hpp"

namespace stepwire::cli {
namespace {

constexpr double period = 0.01;    // [s]
constexpr int steps_of_write = 2;  // between two commands
constexpr int steps_of_line = 20;  // between two printed lines
constexpr double most_duration = 3600.0;

struct IoCall {
  std::string file, set, duration_text = "5";
  double duration = 0.0;  // [s]
};

/// Returns a duration: "10" in seconds, or with a unit.
double duration_of(const std::string& text) {
  const auto quantity = unit::parse_quantity(text);
  const unit::Dimension time = unit::parse_unit("s")->dimension;
  if (quantity && quantity->dimension.value_or(time) == time && quantity->value > 0.0 &&
      quantity->value <= most_duration)
    return quantity->value;
  throw yaml::Error(yaml::Fault{{"--duration " + text, {}}, "", "must be above 0 and at most 1 h", {}});
}

[[noreturn]] void refuse(const IoCall& call, const std::string& message) {
  throw yaml::Error(yaml::Fault{{"--set " + call.set, {}}, "", message, {}});
}

/// Refuses a value without the unit of its output, or in another one. 0 needs none.
void check_unit(const IoCall& call, const devices::Port& port, const unit::Quantity& quantity) {
  const unit::Dimension wanted = port.dimension.value_or(unit::Dimension{});
  const bool is_zero = quantity.value == 0.0 && !quantity.dimension;
  if (is_zero || quantity.dimension.value_or(unit::Dimension{}) == wanted) return;
  const std::string name = unit::si_name(wanted);
  if (!quantity.dimension)
    refuse(call, fmt::format("has no unit; {} is in {}: {}=0.05{}", port.name, name, port.name, name));
  refuse(call, fmt::format("is in {}; {} is in {}", unit::si_name(*quantity.dimension), port.name, name));
}

/// Returns the outputs with the one that is set; the others have their safe values.
std::vector<double> wanted_outputs(const IoCall& call, const devices::Ports& ports) {
  std::vector<double> outputs;
  for (const devices::Port& port : ports.outputs) outputs.push_back(port.safe.value_or(0.0));
  if (call.set.empty()) return outputs;
  const auto equals = call.set.find('=');
  const auto name = call.set.substr(0, equals);
  const auto quantity =
      equals == std::string::npos ? std::nullopt : unit::parse_quantity(call.set.substr(equals + 1));
  const auto found = std::ranges::find(ports.outputs, name, &devices::Port::name);
  if (!quantity || found == ports.outputs.end())
    refuse(call, "must be an output of the rig with a value, such as current=0.05A");
  check_unit(call, *found, *quantity);
  outputs[static_cast<std::size_t>(found - ports.outputs.begin())] = quantity->value;
  return outputs;
}

void show(const devices::Rig& rig, const devices::Ports& ports, const std::vector<double>& inputs) {
  std::string line;
  for (const devices::InputWire& wire : rig.inputs()) {
    line += fmt::format("  {} {:.6g}", ports.inputs[wire.port].name, inputs[wire.port]);
    if (!wire.unit.empty()) line += " " + wire.unit;
  }
  say("{}\n", text::visible(line));
}

std::chrono::nanoseconds nanoseconds(double seconds) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(seconds));
}

/// Steps until the duration has passed. Each step begins a period after the end of the one before, so late
/// steps are not made up for. A command changes an output by what the rate allows in a period, at most.
///
/// The guard takes the last of several commands where it has lost its processor. n commands change an output
/// by n periods of its rate. At least 2 (n - 1) periods pass between the first and the last of them, and the
/// guard counts one period at least, so it allows them.
void step_all(const IoCall& call, devices::Rig& rig, const devices::Ports& ports) {
  std::vector<double> inputs(ports.inputs.size());
  const std::vector<double> outputs = wanted_outputs(call, ports);
  rig.device().start();
  const auto end = std::chrono::steady_clock::now() + nanoseconds(call.duration);
  for (int i = 0; std::chrono::steady_clock::now() < end && rig.device().healthy() && !interrupted(); ++i) {
    rig.device().read(inputs.data());
    if (!call.set.empty() && i % steps_of_write == 0) rig.device().write(outputs.data());
    if (i % steps_of_line == 0) show(rig, ports, inputs);
    std::this_thread::sleep_for(nanoseconds(period));
  }
  rig.device().rest(outputs.data());
}

/// Raises the times of a rig that are too short for the slow steps of this verb.
void loosen(devices::IoRequest& request) {
  request.late = std::max(request.late.value_or(0.0), 10.0 * period);  // people need no deadlines
  for (devices::InputRequest& one : request.inputs)
    if (one.stuck > 0.0) one.stuck = std::max(one.stuck, period);
}

ExitCode watch_inputs(const IoCall& call) {
  const EndDelay delay(EndDelay::Signals::all);
  devices::IoRequest request = devices::read_io(call.file);
  loosen(request);
  const devices::Ports ports = devices::Ports::of(request);
  wanted_outputs(call, ports);
  devices::Rig rig(request, ports, period, 0, &interrupted());
  step_all(call, rig, ports);
  for (const std::string& line : rig.finish()) say("  {}\n", text::visible(line));
  const std::string trouble = rig.trouble();
  if (!trouble.empty()) complain("{}\n", text::visible(trouble));
  return trouble.empty() ? ExitCode::done : ExitCode::surroundings;
}

Action declare_io(CLI::App& verb) {
  const auto call = std::make_shared<IoCall>();
  verb.add_option("RIG", call->file, "a file of devices and wires, as of loop --io")->required();
  verb.add_option("--set", call->set, "moves one output within its limits and its rate: current=0.05A");
  verb.add_option("--duration", call->duration_text, "for how long [s]")->capture_default_str();
  return [call](const Registry&) {
    call->duration = duration_of(call->duration_text);
    return watch_inputs(*call);
  };
}

}  // namespace

Verb io_verb() {
  return {"io", "show the inputs of a rig live, in SI, and move one output, for wiring",
          "Example:\n  stepwire io rig.yaml --set current=0.05A --duration 2\n"
          "All other outputs have their safe values, and this one at the end.",
          declare_io};
}

}  // namespace stepwire::cli
