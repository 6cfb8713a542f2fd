#include "blocks/math/register.hpp"

#include "blocks/math/abs.hpp"
#include "blocks/math/atan2.hpp"
#include "blocks/math/concatenate.hpp"
#include "blocks/math/cross.hpp"
#include "blocks/math/divide.hpp"
#include "blocks/math/dot.hpp"
#include "blocks/math/expression.hpp"
#include "blocks/math/gain.hpp"
#include "blocks/math/initial_guess.hpp"
#include "blocks/math/inverse.hpp"
#include "blocks/math/inverse_polynomial.hpp"
#include "blocks/math/lookup_table.hpp"
#include "blocks/math/lookup_table_2d.hpp"
#include "blocks/math/lookup_table_nd.hpp"
#include "blocks/math/matrix_gain.hpp"
#include "blocks/math/matrix_multiply.hpp"
#include "blocks/math/min_max.hpp"
#include "blocks/math/norm.hpp"
#include "blocks/math/polynomial.hpp"
#include "blocks/math/product.hpp"
#include "blocks/math/quaternion_product.hpp"
#include "blocks/math/reshape.hpp"
#include "blocks/math/rotate.hpp"
#include "blocks/math/rotate_3d.hpp"
#include "blocks/math/rotation_matrix.hpp"
#include "blocks/math/sign.hpp"
#include "blocks/math/slice.hpp"
#include "blocks/math/sqrt.hpp"
#include "blocks/math/stack.hpp"
#include "blocks/math/sum.hpp"
#include "blocks/math/transpose.hpp"
#include "blocks/math/trig.hpp"

namespace stepwire {

namespace {

void register_matrices(Registry& registry) {
  registry.add<Gain>("math");
  registry.add<MatrixGain>("math");
  registry.add<MatrixMultiply>("math");
  registry.add<Transpose>("math");
  registry.add<Inverse>("math");
  registry.add<Concatenate>("math");
  registry.add<Stack>("math");
  registry.add<Reshape>("math");
  registry.add<Slice>("math");
}

void register_functions(Registry& registry) {
  registry.add<Sum>("math");
  registry.add<Product>("math");
  registry.add<Divide>("math");
  registry.add<Abs>("math");
  registry.add<Sign>("math");
  registry.add<Sqrt>("math");
  registry.add<Trig>("math");
  registry.add<Atan2>("math");
  registry.add<MinMax>("math");
  registry.add<Polynomial>("math");
  registry.add<InversePolynomial>("math");
  registry.add<ExpressionBlock>("math");
  registry.add<InitialGuess>("math");
}

void register_vectors(Registry& registry) {
  registry.add<Norm>("math");
  registry.add<Dot>("math");
  registry.add<Cross>("math");
  registry.add<Rotate>("math");
}

void register_tables(Registry& registry) {
  registry.add<LookupTable>("math");
  registry.add<LookupTable2D>("math");
  registry.add<LookupTableND>("math");
}

void register_rotations(Registry& registry) {
  registry.add<Rotate3D>("math");
  registry.add<RotationMatrix>("math");
  registry.add<QuaternionProduct>("math");
}

}  // namespace

void register_math(Registry& registry) {
  register_matrices(registry);
  register_functions(registry);
  register_vectors(registry);
  register_tables(registry);
  register_rotations(registry);
}

}  // namespace stepwire
