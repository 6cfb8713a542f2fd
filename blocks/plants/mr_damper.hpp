#pragma once

#include "blocks/plants/mr_damper_core.hpp"

namespace stepwire {

/// Linear magnetorheological damper: F = k0 x + c(i) v + alpha(i) z + f0.
struct MRDamper : MRDamperCore {
  Output<1> force{};

  MRDamper();
  void prepare() { scale(1.0, 1.0); }
  void outputs() {
    write_account();
    force = resistance();
  }
  void derivatives() { write_rates(); }
  void update() { remember(); }

  static void declare(Declare<MRDamper>& is);
};

}  // namespace stepwire
