#include "blocks/math/product.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Product::declare(Declare<Product>& is) {
  is.block("Product",
           {.doc = "Multiplies signals element by element. An input of one element counts for every element "
                   "of the others. For a sum of products see Dot.",
            .symbol = {.text = "×"},
            .smooth = true});
  is.input<&Product::u>({.unit = "'u", .doc = "factors", .multiply_units = true});
  is.output<&Product::y>({.unit = "'u", .doc = "the product; its unit is that of the factors multiplied"});
}

}  // namespace stepwire
