#include "blocks/plants/linkage.hpp"

#include <algorithm>

#include "engine/model/block/configure.hpp"
#include "engine/model/block/declare.hpp"

#include "blocks/plants/linkage_declare.hpp"

namespace stepwire {

namespace {

/// Returns the number of link k; a single number applies to all links.
double of_link(const PerElement& numbers, Index k) {
  return numbers[std::min(k, numbers.size() - 1)];
}

/// True for a link with inertia along itself and across, which makes the mass matrix of the pin regular.
bool carries_pin(const LinkageCore& linkage, Index k) {
  const bool across = of_link(linkage.housing_inertia, k) + of_link(linkage.rod_inertia, k) > 0.0;
  return of_link(linkage.rod_mass, k) > 0.0 && (across || linkage.anchors.columns() == 1);
}

}  // namespace

void Linkage::configure(Configure& is) {
  LinkageCore::configure(is);
  bool heavy = pin_mass > 0.0;
  for (Index k = 0; k < links(); ++k) heavy = heavy || carries_pin(*this, k);
  if (!heavy)
    is.refuse<&Linkage::pin_mass>(
        "is 0, and no link has both a rod_mass and an inertia; without mass in every direction no motion "
        "follows from the forces");
}

void Linkage::declare(Declare<Linkage>& is) {
  is.block(
      "Linkage",
      {.doc = "Mechanism of n telescopic links (dampers, motors) from the ground to one pin, on a line, "
              "in the plane or in space, with the masses and inertias of housings and rods. A link is a "
              "housing that turns about its anchor and a rod that slides in it and ends at the pin, both "
              "thin and straight. Joints are revolute in the plane and universal in space, without "
              "friction; no gravity. Forces along the links and on the pin move it, in the plane also "
              "torques about the "
              "anchors. DrivenLinkage is the "
              "same mechanism along a given motion.",
       .source = "Lagrange's equations of the kinetic energy; thesis 2.4, 2.5",
       .at_end = true,
       .smooth = true});
  declare_linkage(is, true);
  is.input<&Linkage::force>({.unit = "N",
                             .doc = "force along each link; positive lengthens it (a damper gives minus its "
                                    "resistance)",
                             .feedthrough = false});
  is.input<&Linkage::external>({.unit = "N",
                                .shape = "d",
                                .doc = "force on the pin from outside, e.g. of a hand",
                                .feedthrough = false,
                                .optional = true});
  is.output<&Linkage::position, &Linkage::position_>({.unit = "m", .shape = "d", .doc = "of the pin"});
  is.output<&Linkage::velocity, &Linkage::velocity_>({.unit = "m/s", .shape = "d", .doc = "of the pin"});
  is.state<&Linkage::position_>({.unit = "m", .shape = "d", .doc = "of the pin"});
  is.state<&Linkage::velocity_>({.unit = "m/s", .shape = "d", .doc = "of the pin"});
}

}  // namespace stepwire
