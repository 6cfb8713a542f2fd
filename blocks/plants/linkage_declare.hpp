#pragma once

#include <string>

#include "blocks/plants/linkage_core.hpp"

namespace stepwire {

/// Returns the number of the link that left its stroke, with its length and limit.
std::string strayed_link(const LinkageCore& linkage);

/// Declares the common parameters and ports of both linkages. Only a free pin needs a mass. Its motion
/// follows from the torques by integration, so no output depends on them at the same instant.
template <class Block>
void declare_linkage(Declare<Block>& is, bool free_pin) {
  is.template parameter<&Block::anchors>(
      {.unit = "m",
       .shape = "n x d",
       .doc = "joints at the ground: a row for each link, with 1, 2 or 3 coordinates",
       .required = true});
  is.template parameter<&Block::pin_mass>({.unit = "kg",
                                           .doc = "point mass at the pin: end-effector and joint",
                                           .at_least = 0.0,
                                           .required = free_pin});
  is.template parameter<&Block::rod_mass>(
      {.unit = "kg", .doc = "of the part that slides and ends at the pin", .at_least = 0.0});
  is.template parameter<&Block::rod_inertia>(
      {.unit = "kg m2", .doc = "of that part about its own centre of mass", .at_least = 0.0});
  is.template parameter<&Block::rod_centre>(
      {.unit = "m", .doc = "how far its centre of mass lies from the pin, toward the anchor"});
  is.template parameter<&Block::housing_inertia>(
      {.unit = "kg m2", .doc = "of the part that only turns, about the anchor", .at_least = 0.0});
  is.template parameter<&Block::shortest>(
      {.unit = "m", .doc = "length of a link below which the run ends", .at_least = 0.0});
  is.template parameter<&Block::longest>(
      {.unit = "m", .doc = "length of a link above which the run ends", .above = 0.0});
  is.template input<&Block::torque>(
      {.unit = "N m",
       .doc = "torque on each link about its anchor, in the plane; positive turns it left (a rotary damper "
              "gives minus its resistance)",
       .feedthrough = !free_pin,
       .optional = true});
  is.template output<&Block::length>({.unit = "m", .doc = "length of each link, anchor to pin"});
  is.template output<&Block::rate>({.unit = "m/s", .doc = "rate of change of each length"});
  is.template output<&Block::angular_rate>(
      {.unit = "rad/s", .doc = "how fast each link turns left about its anchor, in the plane; else 0"});
  is.template output<&Block::kinetic_energy>({.unit = "J", .doc = "of the pin and all links"});
  is.template state<&Block::strayed>(
      {.doc = "number of the link that first left its stroke, 0: none", .settable = false});
  is.template state<&Block::strayed_length>({.unit = "m", .doc = "its length then", .settable = false});
  is.template diagnostic<&Block::out_of_stroke, strayed_link>(
      {.doc = "a link leaves its stroke", .ends_run = true});
  is.template clock<&Block::time>();
}

}  // namespace stepwire
