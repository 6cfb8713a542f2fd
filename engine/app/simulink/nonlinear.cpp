// Discontinuities of Simulink.
#include <fmt/format.h>

#include "engine/app/simulink/forms.hpp"

namespace stepwire::simulink {
namespace {

void saturation(BlockWriter& write) {
  write.make("Saturation")
      .u()
      .limit("lower", "LowerLimit", "-0.5")
      .limit("upper", "UpperLimit", "0.5")
      .every();
}

void dead_zone(BlockWriter& write) {
  write.make("DeadZone").u().key("lower", "LowerValue", "-0.5").key("upper", "UpperValue", "0.5");
}

/// Writes a block whose inputs are the upper limit, the signal and the lower limit.
void write_dynamic(BlockWriter& write, const char* type, const char* lower, const char* upper) {
  write.make(type).key("u", write.source(2)).key(lower, write.source(3)).key(upper, write.source(1));
}

void dynamic_saturation(BlockWriter& write) {
  write_dynamic(write, "Saturation", "lower", "upper");
}
void dynamic_dead_zone(BlockWriter& write) {
  write_dynamic(write, "DeadZone", "lower", "upper");
}
void dynamic_rate_limiter(BlockWriter& write) {
  write_dynamic(write, "RateLimiter", "falling", "rising");
}

void rate_limiter(BlockWriter& write) {
  write.make("RateLimiter")
      .u()
      .key("rising", "RisingSlewLimit", "1")
      .key("falling", "FallingSlewLimit", "-1");
  if (write.text("SampleTimeMode", "continuous") == "continuous")
    write.key("initial", write.source());  // the output begins at the input
  else
    write.key("initial", "InitialCondition", "0");
}

void backlash(BlockWriter& write) {
  write.make("Backlash").u().key("width", "BacklashWidth", "1").key("initial", "InitialOutput", "0").every();
}

void relay(BlockWriter& write) {
  write.make("Relay").u().key("switch_on", "OnSwitchValue", "eps").key("switch_off", "OffSwitchValue", "eps");
  write.key("when_on", "OnOutputValue", "1").key("when_off", "OffOutputValue", "0").every();
}

void quantizer(BlockWriter& write) {
  const std::string interval = in_formula(write.number("QuantizationInterval", "0.5"));
  expression(write, fmt::format("{0}*round(u1/{0})", interval), {word(write.source())}).every();
}

void friction(BlockWriter& write) {
  write.make("Coulomb").u().key("coulomb", "offset", "[1 3 2 0]").key("viscous", "gain", "1");
}

}  // namespace

std::vector<Translation> nonlinear_translations() {
  return {{"Saturate", "`Saturation`", saturation},
          {"Saturation Dynamic", "`Saturation` with signals as limits", dynamic_saturation},
          {"DeadZone", "`DeadZone`", dead_zone},
          {"Dead Zone Dynamic", "`DeadZone` with signals as limits", dynamic_dead_zone},
          {"RateLimiter", "`RateLimiter`", rate_limiter},
          {"Rate Limiter Dynamic", "`RateLimiter` with signals as rates", dynamic_rate_limiter},
          {"Backlash", "`Backlash`", backlash},
          {"Relay", "`Relay`", relay},
          {"Quantizer", "`Expression`, which rounds halves away from zero", quantizer},
          {"Coulomb & Viscous Friction", "`Coulomb`", friction}};
}

}  // namespace stepwire::simulink
