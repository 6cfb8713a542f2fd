#pragma once

#include "blocks/plants/mr_damper_core.hpp"

namespace stepwire {

/// Linear magnetorheological damper: F = k0 x + c(i) v + alpha(i) z + f0.
struct MRDamper : MRDamperCore {
  double compressed_length = 0.0, extended_length = 0.0;  ///< ratings, without effect on a run
  double continuous_current = 0.0, intermittent_current = 0.0;
  Output<1> force{};

  MRDamper();
  void prepare() { scale(1.0, 1.0); }
  void outputs() { force = write_account(); }
  void derivatives() { write_rates(); }
  void update() { remember(); }

  static void declare(Declare<MRDamper>& is);
};

/// Parameters of thesis eq. 4-6. The units are not printed; mm, N, s and A are assumed. With them the force
/// fits this damper (3 N at 0 A, 34 N at 0.35 A beside the viscous part). Values in SI:
///
///     A      1        mm/mm        as printed
///     beta   1/mm     1e3 1/m      gamma likewise
///     alpha  N/mm     1e3 N/m      each coefficient, per ampere to its power
///     c      N s/mm   1e3 N s/m    each coefficient, per ampere to its power
inline void rd_1097_01(MRDamper& damper) {
  constexpr double per_mm = 1e3;
  damper.k0 = 0.0;
  damper.A = 36.2095;
  damper.beta = 10.6140 * per_mm;
  damper.n = 1.0;
  damper.gamma = -7.0773 * per_mm;
  damper.alpha = {72.8 * per_mm, -42.88 * per_mm, 14.83 * per_mm, 0.29 * per_mm};
  damper.c = {-9.37 * per_mm, 10.22 * per_mm, -4.33 * per_mm, 0.89 * per_mm, 0.02 * per_mm};
  damper.current_range = {0.0, 0.35};
  damper.compressed_length = 0.195;
  damper.extended_length = 0.253;
  damper.continuous_current = 0.5;
  damper.intermittent_current = 1.0;
}

inline MRDamper::MRDamper() {
  rd_1097_01(*this);
}

}  // namespace stepwire
