#include "blocks/operators/forward_model.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void ForwardModel::declare(Declare<ForwardModel>& is) {
  is.block(
      "ForwardModel",
      {.doc = "Forward model of a hand: how it will move by its own command, which a person knows before it "
              "is felt. A mass is led by a spring and a dashpot after an equilibrium that comes through the "
              "muscles late. The only load that it knows of is the learnt one, for which the hand makes up, "
              "so that both cancel. What is felt or seen late is brought to now by how far this model has "
              "moved since.",
       .source = "Wolpert, Ghahramani and Jordan 1995, Science 269:1880; prediction over a delay: Smith 1957",
       .timing = Timing::discrete});
  is.parameter<&ForwardModel::mass>({.unit = "kg", .doc = "of hand and pin", .above = 0.0, .required = true});
  is.parameter<&ForwardModel::muscle>(
      {.unit = "s", .doc = "lag of the muscles", .above = 0.0, .required = true});
  is.input<&ForwardModel::equilibrium>({.unit = "m", .doc = "as commanded", .feedthrough = false});
  is.input<&ForwardModel::stiffness>({.unit = "N/m", .doc = "of the arm, now", .feedthrough = false});
  is.input<&ForwardModel::damping>({.unit = "N s/m", .doc = "of the arm, now", .feedthrough = false});
  is.output<&ForwardModel::position>({.unit = "m", .doc = "of the model"});
  is.output<&ForwardModel::velocity>({.unit = "m/s", .doc = "of the model"});
  is.state<&ForwardModel::x>({.unit = "m", .doc = "position"});
  is.state<&ForwardModel::v>({.unit = "m/s", .doc = "velocity", .settable = false});
  is.state<&ForwardModel::e>({.unit = "m", .doc = "equilibrium behind the muscles"});
  is.clock<&ForwardModel::period>();
}

}  // namespace stepwire
