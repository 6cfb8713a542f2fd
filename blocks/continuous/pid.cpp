#include "blocks/continuous/pid.hpp"

#include "engine/model/block/declare_reset.hpp"
#include "engine/model/block/limits.hpp"

namespace stepwire {

namespace {

void declare_parameters(Declare<PID>& is) {
  is.parameter<&PID::kp>({.unit = "'k", .doc = "proportional gain"});
  is.parameter<&PID::ki>({.unit = "'k/s", .doc = "integral gain"});
  is.parameter<&PID::kd>({.unit = "'k s", .doc = "derivative gain"});
  is.parameter<&PID::tau>({.unit = "s", .doc = "time constant of the derivative filter", .above = 0.0});
  is.parameter<&PID::lower>({.unit = "'k 'u", .doc = "lowest output; none where left out"});
  is.parameter<&PID::upper>({.unit = "'k 'u", .doc = "highest output; none where left out"});
  is.parameter<&PID::integral_lower>({.unit = "'k 'u", .doc = "lowest integral part; none where left out"});
  is.parameter<&PID::integral_upper>({.unit = "'k 'u", .doc = "highest integral part; none where left out"});
  is.parameter<&PID::anti_windup>({.doc = "what the integral part does while the output is at a limit: goes "
                                          "on (none), stops where it would push "
                                          "further out (clamping), or follows the output, di/dt = ki e + (y "
                                          "- wanted) / tracking (back_calculation)",
                                   .words = {"none", "clamping", "back_calculation"}});
  is.parameter<&PID::tracking>(
      {.unit = "s",
       .doc = "time constant of back_calculation, and with which the integral part follows `actual`",
       .above = 0.0});
  is.parameter<&PID::weight_p>(
      {.doc = "share of the reference that the proportional part sees", .structural = true});
  is.parameter<&PID::weight_d>(
      {.doc = "share of the reference that the derivative part sees; 0: no kick at a step",
       .structural = true});
  is.parameter<&PID::settled>(
      {.doc =
           "the derivative part is 0 at the first instant and at a reset, whatever the error is; false: its "
           "filter begins at 0, and an error gives a peak of kd e / tau"});
}

}  // namespace

void PID::declare(Declare<PID>& is) {
  is.block("PID",
           {.doc = "Continuous PID controller in parallel form: y = kp e + ki int(e) + kd de/dt filtered by "
                   "1 / (tau s + 1), within limits. u is the error e, reference minus measurement. Where "
                   "`actual` is wired, what the actuator really does, the integral part follows it: di/dt = "
                   "ki e + (actual - y) / tracking. By hand y is `manual`, and the integral part takes what "
                   "makes the controller go on from there without a bump. At the first instant and at a "
                   "reset the derivative part is 0; a reference that jumps later gives its peak.",
            .source = "Åström, Hägglund, Advanced PID Control, 2006, sections 3.3 to 3.5",
            .discrete = "DiscretePID",
            .smooth = true});
  declare_parameters(is);
  is.input<&PID::u>({.unit = "'u", .doc = "error, reference minus measurement"});
  is.input<&PID::reference>({.unit = "'u", .doc = "needed only for weights other than 1", .optional = true});
  is.input<&PID::actual>({.unit = "'k 'u",
                          .doc = "what becomes of the command behind the controller, as a saturated actuator",
                          .feedthrough = false,
                          .optional = true});
  is.input<&PID::manual>({.unit = "'k 'u", .doc = "the command by hand", .optional = true});
  is.input<&PID::automatic>(
      {.unit = "*", .doc = "above 0 the controller acts; else y is `manual`", .optional = true});
  is.output<&PID::y>({.unit = "'k 'u", .doc = "command"});
  is.state<&PID::integral>({.unit = "'k 'u", .doc = "integral part"});
  is.state<&PID::filter>({.unit = "'u", .doc = "what the derivative part sees, filtered", .settable = false});
  is.state<&PID::hand>({.shape = "1", .doc = "1 while the command is given by hand", .settable = false});
  is.state<&PID::begun>({.doc = "0 before the first step, then 1", .settable = false, .marks_start = true});
  is.state<&PID::at_limit>(
      {.doc = "limit that the output would exceed at the last instant: 2 or 1 the upper, -2 or "
              "-1 the lower, 0 none",
       .settable = false});
  is.state<&PID::stop>({.doc =
                            "1 if the integral part was at its upper and -1 at its lower limit at the last "
                            "instant, else 0",
                        .settable = false});
  declare_reset(is, "'k 'u", "the integral part");
  is.crossing_of<&PID::automatic>("the controller takes over, or the hand");
  is.crossing<&PID::u, &PID::reference, &PID::manual>("the output meets or leaves its lower limit");
  is.crossing<&PID::u, &PID::reference, &PID::manual>("it meets or leaves its upper limit");
  is.crossing<&PID::u, &PID::reference, &PID::actual>("the integral part meets or leaves its lower limit");
  is.crossing<&PID::u, &PID::reference, &PID::actual>("it meets or leaves its upper limit");
  is.derived<&PID::plain, From::no_number>();
}

void PID::configure(Configure& is) {
  require_order<&PID::lower, &PID::upper>(*this, is);
  require_order<&PID::integral_lower, &PID::integral_upper>(*this, is);
  if (!all_are(weight_p, 1.0) || !all_are(weight_d, 1.0))
    is.require<&PID::reference>("a weight other than 1 needs it");
  const bool by_hand = is.connected<&PID::manual>();
  if (by_hand) is.require<&PID::automatic>("a command by hand is wired");
  if (is.connected<&PID::automatic>()) is.require<&PID::manual>("it says when the command is given by hand");
  plain = !configure_reset(*this, is) && !by_hand;
  is.skip_instants(plain);
  is.skip_before_instant(trigger != Trigger::level || !is.connected<&PID::reset>());
  const bool has_limits = limits(lower, upper), of_integral = limits(integral_lower, integral_upper);
  if (plain && !has_limits && !of_integral) is.skip_crossings();
  if (!plain || of_integral) return;
  if (!settled && anti_windup != AntiWindup::clamping) is.remember_nothing();  // nothing depends on at_limit
  if (settled || has_limits)
    is.update_keeps_outputs();
  else
    is.skip_update();
}

}  // namespace stepwire
