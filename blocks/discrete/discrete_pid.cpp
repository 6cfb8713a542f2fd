#include "blocks/discrete/discrete_pid.hpp"

#include "engine/model/block/declare_reset.hpp"
#include "engine/model/block/limits.hpp"

namespace stepwire {

namespace {

void declare_gains(Declare<DiscretePID>& is) {
  is.parameter<&DiscretePID::kp>({.unit = "'k", .doc = "proportional gain"});
  is.parameter<&DiscretePID::ki>({.unit = "'k/s", .doc = "integral gain"});
  is.parameter<&DiscretePID::kd>({.unit = "'k s", .doc = "derivative gain"});
  is.parameter<&DiscretePID::tau>({.unit = "s",
                                   .doc = "time constant of the derivative filter; 0: the plain difference",
                                   .at_least = 0.0});
  is.parameter<&DiscretePID::method>({.doc = "how the integral part sums ki T e: forward_euler shows e[k] "
                                             "from the next tick on, backward_euler at "
                                             "once, trapezoidal half of it at once",
                                      .words = {"forward_euler", "backward_euler", "trapezoidal"}});
  is.parameter<&DiscretePID::weight_p>(
      {.doc = "share of the reference that the proportional part sees", .structural = true});
  is.parameter<&DiscretePID::weight_d>(
      {.doc = "share of the reference that the derivative part sees; 0: no kick at a step",
       .structural = true});
  is.parameter<&DiscretePID::settled>(
      {.doc =
           "D is 0 at the first tick and at a reset, whatever the error is; false: the error before is taken "
           "for 0, and an error gives a peak of kd e / (tau + T)"});
}

void declare_limits(Declare<DiscretePID>& is) {
  is.parameter<&DiscretePID::lower>({.unit = "'k 'u", .doc = "lowest output; none where left out"});
  is.parameter<&DiscretePID::upper>({.unit = "'k 'u", .doc = "highest output; none where left out"});
  is.parameter<&DiscretePID::integral_lower>(
      {.unit = "'k 'u", .doc = "lowest integral part; none where left out"});
  is.parameter<&DiscretePID::integral_upper>(
      {.unit = "'k 'u", .doc = "highest integral part; none where left out"});
  is.parameter<&DiscretePID::anti_windup>(
      {.doc =
           "what the integral part I does while the output is at a limit: goes on (none), stops where it "
           "would push "
           "further out (clamping), or follows the output, I += T / tracking (y - wanted) (back_calculation)",
       .words = {"none", "clamping", "back_calculation"}});
  is.parameter<&DiscretePID::tracking>(
      {.unit = "s",
       .doc = "time constant of back_calculation, and with which the integral part follows `actual`",
       .above = 0.0});
}

}  // namespace

void DiscretePID::declare(Declare<DiscretePID>& is) {
  is.block(
      "DiscretePID",
      {.doc =
           "Discrete PID controller in parallel form at its ticks: y = kp e + I + kd D within limits, with "
           "I += ki T e (forward Euler unless `method` says otherwise) and "
           "D[k] = (tau D[k-1] + e[k] - e[k-1]) / (tau + T). u is the error e, reference minus measurement. "
           "D is 0 at the first tick and at a reset; a reference that jumps later gives its peak. Where "
           "`actual` is wired, what the "
           "actuator "
           "really does, the integral part follows it: I += T / tracking (actual - y). By hand y is "
           "`manual`, "
           "and the integral part takes what makes the controller go on from there without a bump.",
       .source = "Åström, Hägglund, Advanced PID Control, 2006, sections 3.3 to 3.5 and 13.2",
       .symbol = {.text = "PID(z)"}});
  declare_gains(is);
  declare_limits(is);
  is.input<&DiscretePID::u>({.unit = "'u", .doc = "error, reference minus measurement"});
  is.input<&DiscretePID::reference>(
      {.unit = "'u", .doc = "needed only for weights other than 1", .optional = true});
  is.input<&DiscretePID::actual>(
      {.unit = "'k 'u",
       .doc = "what becomes of the command behind the controller, as a saturated actuator",
       .feedthrough = false,
       .optional = true});
  is.input<&DiscretePID::manual>({.unit = "'k 'u", .doc = "the command by hand", .optional = true});
  is.input<&DiscretePID::automatic>(
      {.unit = "*", .doc = "above 0 the controller acts; else y is `manual`", .optional = true});
  is.output<&DiscretePID::y>({.unit = "'k 'u", .doc = "command"});
  is.state<&DiscretePID::integral>({.unit = "'k 'u", .doc = "integral part"});
  is.state<&DiscretePID::rate>({.unit = "'u/s", .doc = "D at the last tick", .settable = false});
  is.state<&DiscretePID::last>({.unit = "'u", .doc = "error in D at the last tick", .settable = false});
  is.state<&DiscretePID::hand>(
      {.shape = "1", .doc = "1 while the command is given by hand", .settable = false});
  is.state<&DiscretePID::begun>(
      {.doc = "0 before the first tick, then 1", .settable = false, .marks_start = true});
  declare_reset(is, "'k 'u", "the integral part");
  is.clock<&DiscretePID::period>();
  is.derived<&DiscretePID::before, From::no_number>();
  is.derived<&DiscretePID::after, From::no_number>();
  is.derived<&DiscretePID::plain, From::no_number>();
  is.prepared<&DiscretePID::per_time>();
}

void DiscretePID::configure(Configure& is) {
  require_order<&DiscretePID::lower, &DiscretePID::upper>(*this, is);
  require_order<&DiscretePID::integral_lower, &DiscretePID::integral_upper>(*this, is);
  if (!all_are(weight_p, 1.0) || !all_are(weight_d, 1.0))
    is.require<&DiscretePID::reference>("a weight other than 1 needs it");
  const bool by_hand = is.connected<&DiscretePID::manual>();
  if (by_hand) is.require<&DiscretePID::automatic>("a command by hand is wired");
  if (is.connected<&DiscretePID::automatic>())
    is.require<&DiscretePID::manual>("it says when the command is given by hand");
  plain = !configure_reset(*this, is) && !by_hand;
  before = method == Method::forward_euler ? 0.0 : method == Method::backward_euler ? 1.0 : 0.5;
  after = 1.0 - before;
}

}  // namespace stepwire
