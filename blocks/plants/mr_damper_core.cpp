#include "blocks/plants/mr_damper_core.hpp"

#include <fmt/core.h>

#include "engine/model/block/configure.hpp"

namespace stepwire {

namespace {

using Core = MRDamperCore;

void refuse_what_gives_energy(const Core& damper, const Configure& is) {
  if (!(damper.A > 0.0)) is.refuse<&Core::A>(fmt::format("{} is not allowed; it must be above 0", damper.A));
  if (damper.z_max == 0.0 && std::abs(damper.gamma) > damper.beta)
    is.refuse<&Core::gamma>(
        fmt::format("|gamma| = {} is above beta = {}, so the damper would give out energy; it must be "
                    "at most beta",
                    std::abs(damper.gamma), damper.beta));
}

void check_range(const Numbers& range, const Configure& is) {
  if (range.size() != 2 || !(range[0] < range[1]))
    is.refuse<&Core::current_range>("is not a lower and a higher current, such as [0 A, 0.35 A]");
}

/// Refuses coefficients that are negative inside the range, where the damper would push instead of resisting.
/// Outside of it the user has chosen `raw`.
template <auto coefficients>
void refuse_pushing(const Core& damper, const Configure& is) {
  constexpr int steps = 100;
  if ((damper.*coefficients).size() == 0) is.refuse<coefficients>("has no coefficient; a constant needs one");
  if (damper.extrapolate == Core::Outside::raw) return;
  for (int k = 0; k <= steps; ++k) {
    const double i =
        damper.current_range[0] + k * (damper.current_range[1] - damper.current_range[0]) / steps;
    const double value = Core::polynomial(damper.*coefficients, i);
    if (value < 0.0)
      is.refuse<coefficients>(
          fmt::format("is {} at {} A, where a damper would push; it must not be negative inside "
                      "current_range (or take 'extrapolate: raw')",
                      value, i));
  }
}

}  // namespace

void MRDamperCore::configure(Configure& is) {
  refuse_what_gives_energy(*this, is);
  check_range(current_range, is);
  refuse_pushing<&Core::alpha>(*this, is);
  refuse_pushing<&Core::c>(*this, is);
  const bool exact = integration == Integration::exact;
  if (k0 != 0.0) is.require<&Core::position>("k0 is not 0");

  is.feedthrough<&Core::velocity, &Core::z>(exact);
  is.feedthrough<&Core::velocity, &Core::dissipated>(exact);
  is.feedthrough<&Core::velocity, &Core::stored>(exact);
  is.feedthrough<&Core::velocity, &Core::switching_work>(exact);
  is.feedthrough<&Core::current, &Core::z>(false);
  is.feedthrough<&Core::current, &Core::dissipated>(exact);
  is.feedthrough<&Core::position, &Core::z>(false);
  is.feedthrough<&Core::position, &Core::dissipated>(false);
  is.feedthrough<&Core::position, &Core::stored>(false);
  is.feedthrough<&Core::position, &Core::switching_work>(false);
}

}  // namespace stepwire
