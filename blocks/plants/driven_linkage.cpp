#include "blocks/plants/driven_linkage.hpp"

#include "engine/model/block/configure.hpp"
#include "engine/model/block/declare.hpp"

#include "blocks/plants/linkage_declare.hpp"

namespace stepwire {

void DrivenLinkage::configure(Configure& is) {
  LinkageCore::configure(is);
  is.feedthrough<&DrivenLinkage::velocity, &DrivenLinkage::length>(false);
  is.feedthrough<&DrivenLinkage::acceleration, &DrivenLinkage::length>(false);
  is.feedthrough<&DrivenLinkage::acceleration, &DrivenLinkage::rate>(false);
  is.feedthrough<&DrivenLinkage::acceleration, &DrivenLinkage::angular_rate>(false);
  is.feedthrough<&DrivenLinkage::acceleration, &DrivenLinkage::kinetic_energy>(false);
  is.feedthrough<&DrivenLinkage::force, &DrivenLinkage::length>(false);
  is.feedthrough<&DrivenLinkage::force, &DrivenLinkage::rate>(false);
  is.feedthrough<&DrivenLinkage::force, &DrivenLinkage::angular_rate>(false);
  is.feedthrough<&DrivenLinkage::force, &DrivenLinkage::kinetic_energy>(false);
  is.feedthrough<&DrivenLinkage::torque, &DrivenLinkage::length>(false);
  is.feedthrough<&DrivenLinkage::torque, &DrivenLinkage::rate>(false);
  is.feedthrough<&DrivenLinkage::torque, &DrivenLinkage::angular_rate>(false);
  is.feedthrough<&DrivenLinkage::torque, &DrivenLinkage::kinetic_energy>(false);
}

void DrivenLinkage::declare(Declare<DrivenLinkage>& is) {
  is.block(
      "DrivenLinkage",
      {.doc = "The mechanism of Linkage along a given motion of its pin: what force from outside it takes "
              "(inverse dynamics). With a StraightMotion this is a kinematic pusher, which moves the pin "
              "at constant speed whatever resists.",
       .source = "as Linkage",
       .timing = Timing::continuous,
       .at_end = true,
       .smooth = true});
  declare_linkage(is, false);
  is.input<&DrivenLinkage::position>({.unit = "m", .shape = "d", .doc = "of the pin"});
  is.input<&DrivenLinkage::velocity>(
      {.unit = "m/s", .shape = "d", .doc = "of the pin, the derivative of the position"});
  is.input<&DrivenLinkage::acceleration>(
      {.unit = "m/s2", .shape = "d", .doc = "of the pin; 0 where nothing is wired", .optional = true});
  is.input<&DrivenLinkage::force>({.unit = "N",
                                   .doc =
                                       "force along each link; positive lengthens it (a damper gives minus "
                                       "its resistance)"});
  is.output<&DrivenLinkage::external>(
      {.unit = "N", .shape = "d", .doc = "force on the pin from outside that this motion takes"});
}

}  // namespace stepwire
