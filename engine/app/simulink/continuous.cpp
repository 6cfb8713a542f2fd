// Continuous blocks of Simulink.
#include <fmt/format.h>

#include <algorithm>

#include "engine/app/simulink/forms.hpp"

namespace stepwire::simulink {
namespace {

void integrator(BlockWriter& write) {
  const std::string reset = write.text("ExternalReset", "none");
  if (reset == "sampled level" || reset == "level hold")
    throw Untranslated("its external reset is '" + reset + "'");
  if (write.is_on("ShowSaturationPort")) throw Untranslated("it shows its saturation");
  if (write.is_on("WrapState")) throw Untranslated("it wraps its state");
  write.collected().has_states = true;
  write.make("Integrator").u();
  add_integrator_keys(write);
  write.output(0, write.name() + ".before");
}

/// Writes both integrators of Integrator, Second-Order: x and dx.
void second_order(BlockWriter& write) {
  for (const char* name : {"LimitX", "LimitDXDT"})
    if (write.is_on(name)) throw Untranslated("it limits its states");
  require(write, "ExternalReset", "none");
  require(write, "ICSourceX", "internal");
  require(write, "ICSourceDXDT", "internal");
  write.collected().has_states = true;
  const std::string rate = write.extra(
      "dx", block_node("Integrator",
                       {{"u", word(write.source())}, {"initial", value_node(write.finite("ICDXDT", "0"))}}));
  write.make("Integrator").key("u", rate).key("initial", "ICX", "0").output(2, rate);
}

void derivative(BlockWriter& write) {
  const double tau = write.collected().step;
  write.collected().has_states = true;
  write.make("Derivative").u().key("tau", fmt::format("{}", tau));
  write.deviates(
      fmt::format("takes differences between steps in Simulink, and is filtered with tau = {} s here", tau));
}

void transfer_function(BlockWriter& write) {
  const Value numerator = write.finite("Numerator", "[1]"),
              denominator = write.finite("Denominator", "[1 2 1]");
  write.say_default("Denominator", "[1 2 1]");
  if (!numerator.is_vector()) throw Untranslated("its numerator has several rows, one for each output");
  write.collected().has_states = true;
  write.make("TransferFunction")
      .u()
      .key("numerator", list_node(numerator))
      .key("denominator", list_node(denominator));
}

void zero_pole(BlockWriter& write) {
  const Value zeros = write.value("Zeros", "[1]"), poles = write.finite("Poles", "[0 -1]"),
              gain = write.finite("Gain", "1");
  if (!gain.is_scalar() || (!zeros.cells.empty() && !zeros.is_vector()))
    throw Untranslated("it has several outputs");
  write.say_default("Poles", "[0 -1]");
  write.collected().has_states = true;
  write.make("TransferFunction").u().key("numerator", list_node(each('*', gain, polynomial_of_roots(zeros))));
  write.key("denominator", list_node(polynomial_of_roots(poles)));
}

/// Returns the name of a parameter that older releases call by another one.
std::string either(const BlockWriter& write, const std::string& name, const std::string& old) {
  return write.block().texts.contains(old) ? old : name;
}

void state_space(BlockWriter& write) {
  const bool is_discrete = write.block().type == "DiscreteStateSpace";
  write.make(is_discrete ? "DiscreteStateSpace" : "StateSpace").u();
  for (const char* name : {"A", "B", "C", "D"}) write.key(name, rows_node(write.finite(name, "1")));
  const Value initial = write.finite(either(write, "InitialCondition", "X0"), "0");
  const Value a = write.value("A", "1");
  Value whole = initial;
  if (initial.is_scalar() && a.rows > 1) whole = {1, a.rows, std::vector<Cell>(a.rows, initial.cells[0])};
  write.key("initial", whole.is_scalar() ? cell_node(whole.cells[0]) : list_node(whole));
  if (!is_discrete) {
    write.collected().has_states = true;
    return;
  }
  write.say_default("SampleTime", "1");
  write.every("SampleTime", "1");
}

void transport_delay(BlockWriter& write) {
  write.collected().has_states = true;
  const Cell time = write.number("DelayTime", "1");
  if (time.number > 0.0) write.collected().shortest = std::min(write.collected().shortest, time.number);
  yaml::Node delay = cell_node(time);
  write.make("TransportDelay").u().key("delay", std::move(delay)).key("initial", "InitialOutput", "0");
}

void variable_delay(BlockWriter& write) {
  const std::string kind = write.text("VariableDelayType", "Variable transport delay");
  if (kind != "Variable time delay")
    throw Untranslated("it is a " + kind + ", whose delay is that of a moving medium");
  write.collected().has_states = true;
  write.make("TransportDelay").u().key("delay", write.source(2)).key("longest", "MaximumDelay", "10");
  write.key("initial", "InitialOutput", "0");
}

}  // namespace

std::vector<Translation> continuous_translations() {
  return {{"Integrator", "`Integrator` with limits, reset, initial value from outside", integrator},
          {"SecondOrderIntegrator", "two `Integrator`s", second_order},
          {"Derivative", "`Derivative` with the step as its `tau`", derivative},
          {"TransferFcn", "`TransferFunction`", transfer_function},
          {"ZeroPole", "`TransferFunction`", zero_pole},
          {"StateSpace", "`StateSpace`", state_space},
          {"DiscreteStateSpace", "`DiscreteStateSpace`", state_space},
          {"TransportDelay", "`TransportDelay`", transport_delay},
          {"VariableTransportDelay", "`TransportDelay` of a variable time delay", variable_delay},
          {"VariableTimeDelay", "`TransportDelay` of a variable time delay", variable_delay}};
}

}  // namespace stepwire::simulink
