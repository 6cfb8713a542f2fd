#include "blocks/plants/mr_damper.hpp"

#include "engine/block/declare.hpp"

#include "blocks/plants/mr_damper_declare.hpp"

namespace stepwire {

namespace {

/// Thesis eq. 4-6. The units are not printed; displacement in mm, force in N, time in s and current in A are
/// assumed, since the force is then that of this damper (3 N at 0 A, 34 N at 0.35 A beside the viscous part).
/// In SI:
///
///     A      1        mm/mm        as printed
///     beta   1/mm     1e3 1/m      gamma alike
///     alpha  N/mm     1e3 N/m      each coefficient, per ampere to its power
///     c      N s/mm   1e3 N s/m    each coefficient, per ampere to its power
void rd_1097_01(MRDamper& damper) {
  constexpr double per_mm = 1e3;
  damper.k0 = 0.0;
  damper.A = 36.2095;
  damper.beta = 10.6140 * per_mm;
  damper.n = 1.0;
  damper.gamma = -7.0773 * per_mm;
  damper.alpha = {72.8 * per_mm, -42.88 * per_mm, 14.83 * per_mm, 0.29 * per_mm};
  damper.c = {-9.37 * per_mm, 10.22 * per_mm, -4.33 * per_mm, 0.89 * per_mm, 0.02 * per_mm};
  damper.current_range = {0.0, 0.35};
}

}  // namespace

MRDamper::MRDamper() {
  rd_1097_01(*this);
}

void MRDamper::declare(Declare<MRDamper>& is) {
  is.block(
      "MRDamper",
      {.doc =
           "Linear magnetorheological damper, F = k0 x + c(i) v + alpha(i) z + f0 with "
           "dz/dt = A v - beta |v| |z|^(n-1) z - gamma v |z|^n; z is a length and A a pure number. "
           "Parameters may be written as papers print them, in mm, N, s, A: beta: 10.614 1/mm, "
           "alpha: {value: [72.8, -42.88, 14.83, 0.29], unit: N/mm}, c: {value: [...], unit: N s/mm}; the "
           "powers of the ampere are understood. Left out, a parameter is that of the RD-1097-01. "
           "Refused is what is no damper: A <= 0, |gamma| > beta, alpha or c negative within current_range.",
       .source = "thesis eq. 1, 2, 4-6; B. F. Spencer et al. 1997"});
  declare_mr_damper(is, {.displacement = "m",
                         .velocity = "m/s",
                         .resistance = "N",
                         .stiffness = "N/m",
                         .per_displacement = "1/m",
                         .alpha = "N/m",
                         .c = "N s/m"});
  is.output<&MRDamper::force>({.unit = "N", .doc = "force that resists the motion, in the direction of v"});
  is.preset<rd_1097_01>("rd-1097-01", "Lord RD-1097-01 as identified in the thesis, 0 to 0.35 A");
}

}  // namespace stepwire
