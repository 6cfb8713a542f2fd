// PID controllers of Simulink.
#include <fmt/format.h>

#include "engine/app/simulink/forms.hpp"

namespace stepwire::simulink {
namespace {

/// Gains of a controller in the parallel form.
struct Gains {
  Value p, i, d;
};

Gains gains_of(const BlockWriter& write) {
  const std::string controller = write.text("Controller", "PID");
  const auto gain = [&](char letter, const char* name, const char* otherwise) {
    return controller.find(letter) == controller.npos ? Value::of(0.0) : write.finite(name, otherwise);
  };
  Gains gains{gain('P', "P", "1"), gain('I', "I", "1"), gain('D', "D", "0")};
  if (write.text("Form", "Parallel") == "Ideal" && controller.find('P') != controller.npos) {
    gains.i = each('*', gains.p, gains.i);
    gains.d = each('*', gains.p, gains.d);
  }
  return gains;
}

bool is_zero(const Value& value) {
  return value.is_scalar() && value.cells[0].text.empty() && value.cells[0].number == 0.0;
}

void refuse_what_is_missing(const BlockWriter& write) {
  for (const char* name : {"TrackingMode", "LinearizeAsGain"})
    if (write.is_on(name) && std::string(name) == "TrackingMode")
      throw Untranslated("it tracks a signal; wire that to `actual` of PID");
  if (write.text("ExternalReset", "none") != "none")
    throw Untranslated("it has an external reset; wire that to `reset` of PID");
  if (write.text("InitialConditionSource", "internal") == "external")
    throw Untranslated("its initial values come from outside");
  if (write.text("ControllerParametersSource", "internal") == "external")
    throw Untranslated("its gains come from outside");
}

void add_limits(BlockWriter& write) {
  if (!write.is_on("LimitOutput") && !write.is_on("LimitIntegrator")) return;
  if (write.is_on("LimitIntegrator"))
    write.limit("integral_lower", "LowerIntegratorSaturationLimit", "-inf")
        .limit("integral_upper", "UpperIntegratorSaturationLimit", "inf");
  if (!write.is_on("LimitOutput")) return;
  write.limit("lower", "LowerSaturationLimit", "-inf").limit("upper", "UpperSaturationLimit", "inf");
  const std::string mode = write.text("AntiWindupMode", "none");
  if (mode == "back-calculation")
    write.key("anti_windup", "back_calculation")
        .key("tracking", each('/', Value::of(1.0), write.finite("Kb", "1")));
  else
    write.key("anti_windup", mode == "clamping" ? "clamping" : "none");
}

std::string method_of(const std::string& method) {
  if (method == "Forward Euler") return "forward_euler";
  if (method == "Backward Euler") return "backward_euler";
  if (method == "Trapezoidal") return "trapezoidal";
  throw Untranslated("it integrates by " + method);
}

void add_initial(BlockWriter& write) {
  const Value integral = write.finite("InitialConditionForIntegrator", "0");
  if (!is_zero(integral)) write.key("initial", integral);
  if (!is_zero(write.finite("InitialConditionForFilter", "0")))
    throw Untranslated("its derivative filter has an initial value");
}

void continuous(BlockWriter& write, const Gains& gains) {
  write.collected().has_states = true;
  write.key("kp", gains.p).key("ki", gains.i);
  if (!is_zero(gains.d)) {
    write.key("kd", gains.d);
    if (write.is_on("UseFilter", "on")) {
      write.key("tau", each('/', Value::of(1.0), write.finite("N", "100")));
    } else {
      write.key("tau", fmt::format("{}", write.collected().step));
      write.deviates(fmt::format("its derivative has no filter, and is filtered with tau = {} s here",
                                 write.collected().step));
    }
    write.key("settled", "false");
  }
  add_initial(write);
  add_limits(write);
}

void discrete(BlockWriter& write, const Gains& gains) {
  write.key("kp", gains.p)
      .key("ki", gains.i)
      .key("method", method_of(write.text("IntegratorMethod", "Forward Euler")));
  if (!is_zero(gains.d)) {
    write.key("kd", gains.d).key("settled", "false");
    if (write.is_on("UseFilter", "on")) {
      const std::string method = write.text("FilterMethod", "Forward Euler");
      if (method != "Backward Euler")
        throw Untranslated(
            fmt::format("its derivative is filtered by {}; DiscretePID filters by Backward Euler", method));
      write.key("tau", each('/', Value::of(1.0), write.finite("N", "100")));
    }
  }
  add_initial(write);
  add_limits(write);
  write.every();
}

void write_controller(BlockWriter& write, bool is_discrete, bool has_two_degrees) {
  refuse_what_is_missing(write);
  const Gains gains = gains_of(write);
  write.make(is_discrete ? "DiscretePID" : "PID");
  if (has_two_degrees) {
    const std::string error = write.extra(
        "error", block_node("Sum", {{"signs", quoted("+-")},
                                    {"u", list_of({word(write.source(1)), word(write.source(2))})}}));
    write.key("u", error)
        .key("reference", write.source(1))
        .key("weight_p", "b", "1")
        .key("weight_d", "c", "1");
  } else {
    write.u();
  }
  is_discrete ? discrete(write, gains) : continuous(write, gains);
}

bool is_discrete(const BlockWriter& write, const char* otherwise) {
  return write.text("TimeDomain", otherwise) == "Discrete-time";
}

void one_degree(BlockWriter& write) {
  write_controller(write, is_discrete(write, "Continuous-time"), false);
}
void two_degrees(BlockWriter& write) {
  write_controller(write, is_discrete(write, "Continuous-time"), true);
}
void sampled(BlockWriter& write) {
  write_controller(write, is_discrete(write, "Discrete-time"), false);
}
void sampled_two_degrees(BlockWriter& write) {
  write_controller(write, is_discrete(write, "Discrete-time"), true);
}

}  // namespace

std::vector<Translation> controller_translations() {
  return {{"PID Controller", "`PID`, `DiscretePID`: `kp`, `ki`, `kd`, `tau` = 1/N", one_degree},
          {"PID Controller (2DOF)", "the same with `reference`, `weight_p`, `weight_d`", two_degrees},
          {"Discrete PID Controller", "`DiscretePID`", sampled},
          {"Discrete PID Controller (2DOF)", "the same with `reference`, `weight_p`, `weight_d`",
           sampled_two_degrees}};
}

}  // namespace stepwire::simulink
