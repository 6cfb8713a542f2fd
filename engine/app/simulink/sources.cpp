// Sources of Simulink: their counterparts and parameters.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "engine/app/simulink/forms.hpp"

namespace stepwire::simulink {
namespace {

void constant(BlockWriter& write) {
  const Value value = write.finite("Value", "1");
  // Without VectorParams1D a row is a matrix of one row.
  const bool is_vector = value.is_vector() && (value.columns == 1 || write.is_on("VectorParams1D", "on"));
  if (write.unit().parent && is_vector) {
    // A Constant has its value from the start on, also while its part is off.
    write.make("Ramp").key("slope", "0").key("initial", value);
    return;
  }
  if (is_vector) {
    write.make("Constant").key("value", value).every("SampleTime", "inf");
    return;
  }
  Value by_columns = transposed(value);
  const std::string numbers =
      write.extra("numbers", block_node("Constant", {{"value", list_node(by_columns)}}));
  write.make("Reshape")
      .key("u", numbers)
      .key("rows", std::to_string(value.rows))
      .key("columns", std::to_string(value.columns));
}

void step(BlockWriter& write) {
  write.make("Step").key("time", "Time", "1").key("before", "Before", "0").key("after", "After", "1");
  write.every("SampleTime", "0");
}

void ramp(BlockWriter& write) {
  const std::string initial = write.text("X0").empty() ? "InitialOutput" : "X0";
  write.make("Ramp").key("slope", "slope", "1").key("start", "start", "0").key("initial", initial, "0");
}

/// Writes a sine of samples: the k-th has the angle 2 pi (k + offset) / samples.
void sampled_sine(BlockWriter& write) {
  const SampleTime time = write.sample_time("SampleTime", "0");
  if (time.kind != SampleTime::Kind::discrete)
    throw Untranslated("it counts samples and has no sample time of its own");
  const Value samples = write.finite("Samples", "10");
  const Value turn = each('*', samples, Value::of(time.period));
  write.make("Sine").key("amplitude", "Amplitude", "1").key("frequency", each('/', Value::of(1.0), turn));
  const Value offset = each('/', write.finite("Offset", "0"), samples);
  write.key("phase", each('*', Value::of(2.0 * std::numbers::pi), offset))
      .key("bias", "Bias", "0")
      .every("SampleTime", "0");
}

void sine(BlockWriter& write) {
  if (write.text("TimeSource", "Use simulation time") != "Use simulation time") {
    const Cell amplitude = write.number("Amplitude", "1"), frequency = write.number("Frequency", "1"),
               phase = write.number("Phase", "0"), bias = write.number("Bias", "0");
    expression(write,
               fmt::format("{}*sin({}*u1 + {}) + {}", in_formula(amplitude), in_formula(frequency),
                           in_formula(phase), in_formula(bias)),
               {word(write.source())});
    return;
  }
  if (write.text("SineType", "Time based") == "Sample based") return sampled_sine(write);
  const Value angular = write.finite("Frequency", "1");
  write.make("Sine")
      .key("amplitude", "Amplitude", "1")
      .key("frequency", divided(angular, 2.0 * std::numbers::pi));
  write.key("phase", "Phase", "0").key("bias", "Bias", "0").every("SampleTime", "0");
}

void sampled_pulse(BlockWriter& write) {
  const SampleTime time = write.sample_time("SampleTime", "1");
  if (time.kind != SampleTime::Kind::discrete)
    throw Untranslated("it counts samples and has no sample time of its own");
  const Value period = write.finite("Period", "2"), each_sample = Value::of(time.period);
  write.make("Pulse").key("amplitude", "Amplitude", "1").key("period", each('*', period, each_sample));
  write.key("width", each('/', write.finite("PulseWidth", "1"), period));
  write.key("delay", each('*', write.finite("PhaseDelay", "0"), each_sample)).every("SampleTime", "1");
}

void pulse(BlockWriter& write) {
  require(write, "TimeSource", "Use simulation time");
  if (write.text("PulseType", "Sample based") == "Sample based") return sampled_pulse(write);
  write.make("Pulse").key("amplitude", "Amplitude", "1").key("period", write.undecided("Period"));
  write.key("width", divided(write.undecided("PulseWidth"), 100.0)).key("delay", "PhaseDelay", "0");
}

void generator(BlockWriter& write) {
  require(write, "WaveForm", "sine");
  require(write, "TimeSource", "Use simulation time");
  const Value frequency = write.finite("Frequency", "1");
  const bool in_hertz = write.text("Units", "Hertz") == "Hertz";
  write.make("Sine").key("amplitude", "Amplitude", "1");
  write.key("frequency", in_hertz ? frequency : divided(frequency, 2.0 * std::numbers::pi));
}

void chirp(BlockWriter& write) {
  write.make("Chirp")
      .key("frequency", "f1", "0.1")
      .key("target_time", "T", "100")
      .key("target_frequency", "f2", "1");
  write.deviates("its frequency goes on beyond the target time in Simulink, and stays here");
}

void clock(BlockWriter& write) {
  // A ramp of slope 1, since the time itself has the unit s and the signals of a model have none.
  write.make("Ramp").key("slope", "1").comment("the time of the run");
  if (write.block().type == "DigitalClock") write.every("SampleTime", "1");
}

void ground(BlockWriter& write) {
  write.output(1, "0");
}

/// Returns the seed of a source of random numbers; 1 where it is an expression that is not evaluated.
std::string seed_of(const BlockWriter& write, const char* name, const char* otherwise) {
  double seed = 1.0;
  try {
    seed = std::abs(std::round(write.known(name, otherwise)));
  } catch (const Untranslated& reason) {
    write.deviates(std::string(reason.what()) + "; the seed 1 is written");
  }
  write.deviates("its seed gives another sequence of numbers than in Simulink");
  return fmt::format("{}", seed);
}

void random_number(BlockWriter& write) {
  const double variance = write.known("Variance", "1");
  write.make("Noise").key("seed", seed_of(write, "Seed", "0")).key("mean", "Mean", "0");
  write.key("deviation", fmt::format("{}", std::sqrt(variance))).every("SampleTime", "-1");
}

void uniform_number(BlockWriter& write) {
  const double low = write.known("Minimum", "-1"), high = write.known("Maximum", "1");
  write.make("Noise").key("seed", seed_of(write, "Seed", "0")).key("distribution", "uniform");
  write.key("mean", fmt::format("{}", (low + high) / 2.0));
  write.key("deviation", fmt::format("{}", (high - low) / std::sqrt(12.0))).every("SampleTime", "-1");
}

void white_noise(BlockWriter& write) {
  write.make("Noise").key("seed", seed_of(write, "seed", "23341"));
  write.key("power", "Cov", "0.1").every("Ts", "0.1");
}

void repeating_sequence(BlockWriter& write) {
  const Value times = write.finite("rep_seq_t", "[0 2]"), values = write.finite("rep_seq_y", "[0 2]");
  const std::vector<double> known = times.numbers();
  if (known.size() < 2 || known[0] != 0.0) throw Untranslated("its times do not begin at 0");
  const std::string time = write.extra("time", block_node("Ramp", {{"slope", word("1")}}));
  const std::string within = write.extra(
      "phase", block_node("Expression", {{"u", word(time)},
                                         {"expression", word(fmt::format("mod(u1, {})", known.back()))}}));
  write.make("LookupTable").key("u", within).key("points", list_node(times)).key("values", list_node(values));
}

void played(BlockWriter& write) {
  throw Untranslated(write.block().type == "FromWorkspace" || write.block().type == "FromFile"
                         ? "its data are not in the model; export them as CSV and use the block FromFile"
                         : "its signals are not read; export them as CSV and use the block FromFile");
}

}  // namespace

std::vector<Translation> source_translations() {
  return {{"Constant", "`Constant`", constant},
          {"Step", "`Step`", step},
          {"Ramp", "`Ramp`", ramp},
          {"Sin", "`Sine`, its frequency in Hz", sine},
          {"DiscretePulseGenerator", "`Pulse`, its width as a share", pulse},
          {"SignalGenerator", "`Sine`; other waves are placeholders", generator},
          {"Chirp Signal", "`Chirp`", chirp},
          {"Clock", "`Ramp` of slope 1, which has no unit", clock},
          {"DigitalClock", "`Ramp` of slope 1 with `every`", clock},
          {"Ground", "the number 0", ground},
          {"RandomNumber", "`Noise`", random_number},
          {"UniformRandomNumber", "`Noise` with `distribution: uniform`", uniform_number},
          {"Band-Limited White Noise", "`Noise` with `power`", white_noise},
          {"Repeating Sequence", "`LookupTable` of the time within a period", repeating_sequence},
          {"FromWorkspace", "a placeholder, to be a `FromFile`", played},
          {"FromFile", "a placeholder, to be a `FromFile`", played}};
}

}  // namespace stepwire::simulink
