#include "blocks/plants/mr_damper.hpp"

#include "engine/model/block/declare.hpp"

#include "blocks/plants/mr_damper_declare.hpp"

namespace stepwire {

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
       .source = "thesis eq. 1, 2, 4-6; B. F. Spencer et al. 1997",
       .at_end = true,
       .smooth = true});
  declare_mr_damper(is, {.displacement = "m",
                         .velocity = "m/s",
                         .resistance = "N",
                         .stiffness = "N/m",
                         .per_displacement = "1/m",
                         .alpha = "N/m",
                         .c = "N s/m"});
  is.output<&MRDamper::force>({.unit = "N", .doc = "force that resists the motion, in the direction of v"});
  const std::string rating = "; of the data sheet, for figures and claims: no run depends on it";
  is.parameter<&MRDamper::compressed_length>({.unit = "m", .doc = "length when pushed in" + rating});
  is.parameter<&MRDamper::extended_length>({.unit = "m", .doc = "length when pulled out" + rating});
  is.parameter<&MRDamper::continuous_current>({.unit = "A", .doc = "highest current for long" + rating});
  is.parameter<&MRDamper::intermittent_current>({.unit = "A", .doc = "highest current for a while" + rating});
  is.preset<rd_1097_01>("rd-1097-01",
                        "Lord RD-1097-01 as identified in the thesis, 0 to 0.35 A, with the ratings of its "
                        "data sheet (thesis table 1)");
}

}  // namespace stepwire
