// Discrete blocks of Simulink.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/app/simulink/forms.hpp"

namespace stepwire::simulink {
namespace {

/// Name of the parameter of the initial value: X0 before R2012.
std::string initial_name(const BlockWriter& write) {
  return write.block().texts.contains("X0") ? "X0" : "InitialCondition";
}

void unit_delay(BlockWriter& write) {
  write.say_default("SampleTime", "1");
  write.make("UnitDelay").u().key("initial", initial_name(write), "0").every("SampleTime", "1");
}

void memory(BlockWriter& write) {
  write.make("UnitDelay").u().key("initial", initial_name(write), "0");
}

void hold(BlockWriter& write) {
  write.make("ZeroOrderHold").u().every("SampleTime", "1");
}

/// Returns the length of a delay in periods. Throws Untranslated for what Delay and UnitDelay do not have.
double delay_length(const BlockWriter& write) {
  if (write.text("DelayLengthSource", "Dialog") != "Dialog")
    throw Untranslated("its length comes from outside; use VariableDelay");
  if (write.text("InitialConditionSource", "Dialog") != "Dialog")
    throw Untranslated("its initial value comes from outside");
  const std::string reset = write.text("ExternalReset", "None");
  if (reset != "None" && reset != "none")
    throw Untranslated("it has an external reset; wire that to `reset`");
  if (write.is_on("ShowEnablePort")) throw Untranslated("it has an enable port; wire that to `enable`");
  const std::string name = write.block().texts.contains("NumDelays") ? "NumDelays" : "DelayLength";
  const double length = write.known(name, "2");
  if (!(length >= 0.0 && length <= 1e6) || length != std::round(length))
    throw Untranslated("its length is no whole number");
  return length;
}

/// Writes a delay of whole periods: Delay with a known period, otherwise UnitDelays in a row.
void delay(BlockWriter& write) {
  const double length = delay_length(write);
  const SampleTime time = write.sample_time();
  const std::string initial = write.block().texts.contains("vinit") ? "vinit" : "InitialCondition";
  if (length == 0.0) return write.output(1, write.source());
  if (length > 1.0 && static_cast<double>(write.finite(initial, "0").cells.size()) == length)
    throw Untranslated("its initial values are those of its periods or of the elements of its signal");
  if (time.kind == SampleTime::Kind::discrete) {
    const Cell whole = combined('*', Cell{length}, time.period);
    write.make("Delay").u().key("delay", cell_node(whole)).key("initial", initial, "0").every();
    return;
  }
  if (length > 100.0) throw Untranslated("it is long and has no sample time of its own; Delay needs one");
  const yaml::Node start = value_node(write.finite(initial, "0"));
  std::string last = write.source();
  for (int i = 1; i < static_cast<int>(length); ++i)
    last = write.extra(std::to_string(i), block_node("UnitDelay", {{"u", word(last)}, {"initial", start}}));
  write.make("UnitDelay").key("u", last).key("initial", start);
}

void discrete_integrator(BlockWriter& write) {
  const std::string method = write.text("IntegratorMethod", "Integration: Forward Euler");
  const std::string reset = write.text("ExternalReset", "none");
  if (reset == "sampled level" || reset == "level hold")
    throw Untranslated("its external reset is '" + reset + "'");
  if (write.is_on("ShowSaturationPort") || write.is_on("ShowStatePort"))
    throw Untranslated("it shows its state or saturation");
  const SampleTime time = write.sample_time("SampleTime", "1");
  const bool sums = method.starts_with("Accumulation");
  if (sums && time.kind != SampleTime::Kind::discrete)
    throw Untranslated("it accumulates and has no sample time of its own");
  const Value gain = write.finite("gainval", "1.0");
  const bool forward = method.ends_with("Forward Euler");
  write.make("DiscreteIntegrator").u().key("gain", sums ? each('/', gain, Value::of(time.period)) : gain);
  write.key("method", forward                              ? "forward_euler"
                      : method.ends_with("Backward Euler") ? "backward_euler"
                                                           : "trapezoidal");
  add_integrator_keys(write);
  write.every("SampleTime", "1");
  if (!forward && !write.text("InitialConditionSetting", write.text("InitialConditionMode", "Output"))
                       .starts_with("State"))
    write.deviates(
        "its first output is its initial value in Simulink; here the first input is already in it");
}

void refuse_initial_states(const BlockWriter& write) {
  const Value initial = write.value("InitialStates", "0");
  const bool is_zero = std::ranges::all_of(
      initial.cells, [](const Cell& cell) { return cell.text.empty() && cell.number == 0.0; });
  if (!is_zero) throw Untranslated("its states begin at other values than 0");
  for (const char* name : {"ExternalReset"})
    if (write.text(name, "None") != "None" && write.text(name, "None") != "none")
      throw Untranslated("it has an external reset");
}

/// Writes a filter whose coefficients belong to falling powers of z.
void write_filter(BlockWriter& write, const Value& numerator, const Value& denominator) {
  if (!numerator.is_vector() || !denominator.is_vector())
    throw Untranslated("it has several filters, one in each row");
  refuse_initial_states(write);
  write.make("DiscreteTransferFunction")
      .u()
      .key("numerator", list_node(numerator))
      .key("denominator", list_node(denominator));
  write.say_default("SampleTime", "1");
  write.every("SampleTime", "1");
}

void discrete_transfer_function(BlockWriter& write) {
  write_filter(write, write.finite("Numerator", "[1]"), write.finite("Denominator", "[1 0.5]"));
}

/// Writes a filter in powers of 1/z.
void filter(BlockWriter& write) {
  const bool is_fir = write.block().type == "DiscreteFir";
  const Value numerator =
      is_fir ? write.finite("Coefficients", "[0.5 0.5]") : write.finite("Numerator", "[1]");
  const Value denominator = is_fir ? Value::of(1.0) : write.finite("Denominator", "[1 0.5]");
  const std::size_t count = std::max(numerator.cells.size(), denominator.cells.size());
  write_filter(write, padded(numerator, count, true), padded(denominator, count, true));
}

void discrete_zero_pole(BlockWriter& write) {
  const Value zeros = write.value("Zeros", "[1]"), poles = write.finite("Poles", "[0 0.5]"),
              gain = write.finite("Gain", "1");
  if (!gain.is_scalar() || (!zeros.cells.empty() && !zeros.is_vector()))
    throw Untranslated("it has several outputs");
  write_filter(write, each('*', gain, polynomial_of_roots(zeros)), polynomial_of_roots(poles));
}

Value pair(double first, double second) {
  return {1, 2, {Cell{first}, Cell{second}}};
}

void difference(BlockWriter& write) {
  if (write.known("ICPrevInput", "0.0") != 0.0)
    throw Untranslated("its previous input begins at another value than 0");
  write.make("DiscreteTransferFunction")
      .u()
      .key("numerator", pair(1.0, -1.0))
      .key("denominator", pair(1.0, 0.0));
}

/// Writes a difference over the period: that of the source's blocks, which is the step without one.
void rate_of_change(BlockWriter& write) {
  if (write.known("ICPrevScaledInput", "0.0") != 0.0)
    throw Untranslated("its previous input begins at another value than 0");
  const Value gain = write.finite("gainval", "1.0");
  write.make("DiscretePID").u().key("kp", "0").key("kd", gain).key("settled", "false");
}

void rate_transition(BlockWriter& write) {
  const SampleTime time = write.sample_time("OutPortSampleTime", "-1");
  if (time.kind == SampleTime::Kind::discrete)
    write.make("ZeroOrderHold").u().every("OutPortSampleTime", "-1");
  else
    write.output(1, write.source());
  if (write.is_on("Deterministic", "on"))
    write.deviates("from a slow to a fast rate it delays by a slow period in Simulink, and not here");
}

}  // namespace

std::vector<Translation> discrete_translations() {
  return {{"UnitDelay", "`UnitDelay`", unit_delay},
          {"Memory", "`UnitDelay` of one step", memory},
          {"ZeroOrderHold", "`ZeroOrderHold`", hold},
          {"Delay", "`Delay`, or `UnitDelay`s in a row", delay},
          {"Integer Delay", "`Delay`", delay},
          {"DiscreteIntegrator", "`DiscreteIntegrator`", discrete_integrator},
          {"DiscreteTransferFcn", "`DiscreteTransferFunction`", discrete_transfer_function},
          {"DiscreteFilter", "`DiscreteTransferFunction`", filter},
          {"DiscreteFir", "`DiscreteTransferFunction`", filter},
          {"DiscreteZeroPole", "`DiscreteTransferFunction`", discrete_zero_pole},
          {"Difference", "`DiscreteTransferFunction`", difference},
          {"Discrete Derivative", "`DiscretePID` with `kd` alone", rate_of_change},
          {"RateTransition", "`ZeroOrderHold`, or nothing", rate_transition}};
}

}  // namespace stepwire::simulink
