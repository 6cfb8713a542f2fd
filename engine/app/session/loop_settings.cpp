#include "engine/app/session/loop_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/unit/unit.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::session {

namespace {

constexpr double slowest = 1.0, fastest = 1e6;  // Limits of the rate [Hz]; a loop polls for Ctrl-C.
constexpr double longest = 1e8;                 // Longest duration [s], three years.

/// Parser of the options of a call, which collects all faults.
class Reader {
 public:
  void refuse(const std::string& option, const std::string& text, const std::string& message) {
    faults_.add({{option + " " + text, {}}, "", message, {}});
  }

  /// Parses a number with an optional unit; NaN after a fault.
  double number(const std::string& option, const std::string& text, const std::string& unit,
                const std::string& example) {
    const auto quantity = unit::parse_quantity(text);
    const auto dimension = unit::parse_unit(unit)->dimension;
    if (quantity && quantity->dimension.value_or(dimension) == dimension) return quantity->value;
    refuse(option, text, fmt::format("must be a number in {}, such as {}", unit, example));
    return std::nan("");
  }

  void refuse_unless(bool right, const std::string& option, const std::string& text,
                     const std::string& message) {
    if (!right) refuse(option, text, message);
  }

  const yaml::Faults& faults() const { return faults_; }

 private:
  yaml::Faults faults_;
};

void read_times(const LoopWords& words, Reader& reader, LoopSettings& settings) {
  settings.rate = reader.number("--rate", words.rate, "Hz", "1000 or '2 kHz'");
  settings.duration = reader.number("--duration", words.duration, "s", "10 or '2 min'");
  const double spin = reader.number("--spin", words.spin, "s", "200us");
  // The comparisons are negated so that NaN, which is already refused, passes.
  reader.refuse_unless(!(settings.rate < slowest || settings.rate > fastest), "--rate", words.rate,
                       "must be from 1 Hz to 1 MHz");
  if (!reader.faults().empty()) return;  // the other checks need a valid period
  const double count = std::round(settings.duration * settings.rate);
  reader.refuse_unless(!(count < 1.0 || settings.duration > longest), "--duration", words.duration,
                       fmt::format("must be at least one period of {:.6g} s, and at most {:.0e} s",
                                   1.0 / settings.rate, longest));
  reader.refuse_unless(
      !(spin < 0.0 || spin * settings.rate >= 1.0), "--spin", words.spin,
      fmt::format("must be from 0 to less than the period of {:.6g} s", 1.0 / settings.rate));
  if (!reader.faults().empty()) return;
  settings.deadlines = static_cast<std::int64_t>(count);
  settings.spin = std::llround(spin * 1e9);
}

void read_cpu(const LoopWords& words, Reader& reader, LoopSettings& settings) {
  settings.cpu = words.cpu;
  if (!words.cpu) return;
  const auto cpus = realtime::allowed_cpus();
  reader.refuse_unless(std::find(cpus.begin(), cpus.end(), *words.cpu) != cpus.end(), "--cpu",
                       std::to_string(*words.cpu),
                       fmt::format("is not there; this program may use {}", fmt::join(cpus, ", ")));
}

}  // namespace

LoopSettings read_loop_settings(const LoopWords& words) {
  Reader reader;
  LoopSettings settings;
  read_times(words, reader, settings);
  read_cpu(words, reader, settings);
  const auto policy = realtime::parse_policy(words.policy);
  reader.refuse_unless(policy.has_value(), "--policy", words.policy,
                       "must be fifo:PRIORITY with 1 to 99, such as fifo:80, or other");
  const auto overrun = realtime::parse_overrun(words.overrun);
  reader.refuse_unless(
      overrun.has_value(), "--overrun", words.overrun,
      "must be skip, catch-up, or stop:N with the number of misses in a row, such as stop:3");
  reader.faults().throw_if_any();
  settings.policy = *policy;
  settings.overrun = *overrun;
  return settings;
}

}  // namespace stepwire::session
