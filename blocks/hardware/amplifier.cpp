#include "blocks/hardware/amplifier.hpp"

#include "engine/model/block/declare.hpp"
#include "engine/model/block/limits.hpp"

namespace stepwire {

void Amplifier::configure(Configure& is) {
  require_order<&Amplifier::lower, &Amplifier::upper>(*this, is);
}

void Amplifier::declare(Declare<Amplifier>& is) {
  is.block("Amplifier",
           {.doc = "A power amplifier in current mode, with a current limit and the lag of its current loop: "
                   "tau di/dt = wanted - i, wanted = gain u within the limits, and 0 while it is inhibited. "
                   "An explicit solver needs steps of at most 2 tau.",
            .source = "thesis 3.3",
            .at_end = true,
            .smooth = true});
  is.parameter<&Amplifier::gain>({.unit = "A/'u", .doc = "current per command; 1 where the command is in A"});
  is.parameter<&Amplifier::lower>({.unit = "A", .doc = "lowest current; none where left out"});
  is.parameter<&Amplifier::upper>({.unit = "A", .doc = "highest current; none where left out"});
  is.parameter<&Amplifier::tau>({.unit = "s", .doc = "time constant of the current loop", .above = 0.0});
  is.input<&Amplifier::u>({.unit = "'u", .doc = "command", .feedthrough = false});
  is.input<&Amplifier::inhibit>({.unit = "*",
                                 .doc = "true switches the bridge off, whatever is asked",
                                 .feedthrough = false,
                                 .optional = true});
  is.output<&Amplifier::current, &Amplifier::current_>({.unit = "A", .doc = "current in the load"});
  is.state<&Amplifier::current_>({.unit = "A", .doc = "current in the load"});
  is.diagnostic<&Amplifier::at_limit>(
      {.doc = "the command asks for more current than the amplifier's limit"});
  is.clock<&Amplifier::time>();
  is.preset<amc_16a20ac>("amc-16a20ac", "AMC 16A20AC, 16 A peak; its bandwidth of 2.5 kHz is assumed");
}

}  // namespace stepwire
