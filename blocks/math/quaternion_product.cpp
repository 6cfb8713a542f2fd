#include "blocks/math/quaternion_product.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void QuaternionProduct::declare(Declare<QuaternionProduct>& is) {
  is.block(
      "QuaternionProduct",
      {.doc = "Product of two quaternions [w, x, y, z] in Hamilton's order, y = left right: turned by right, "
              "then by left. With `inverse` the left one is conjugated: y is the turn from left to right.",
       .symbol = {.text = "p q"},
       .smooth = true});
  is.parameter<&QuaternionProduct::inverse>({.doc = "conjugate the left one"});
  is.input<&QuaternionProduct::left>({.doc = "left factor"});
  is.input<&QuaternionProduct::right>({.doc = "right factor"});
  is.output<&QuaternionProduct::y>({.doc = "the product"});
}

}  // namespace stepwire
