#pragma once

#include <cmath>

#include "engine/model/block/resettable.hpp"
#include "engine/model/signal/lane.hpp"
#include "engine/model/signal/numbers.hpp"

namespace stepwire {

/// Operations on small column-major matrices in the memory of a block; they do not allocate.
namespace dense {

/// Adds sign * matrix * from to `to`, without a temporary.
template <class From, class To>
void add(const Matrix& matrix, const From& from, To& to, double sign = 1.0) {
  for (Index j = 0; j < matrix.columns(); ++j) {
    const double factor = sign * from[j];
    for (Index i = 0; i < matrix.rows(); ++i) to[i] += matrix(i, j) * factor;
  }
}

/// Computes out (rows x columns) = a (rows x inner) b (inner x columns); `a(i, k)` and `b(k, j)` are
/// functions.
template <class A, class B>
void multiply(Index rows, Index inner, Index columns, const A& a, const B& b, Lane out) {
  for (Index j = 0; j < columns; ++j)
    for (Index i = 0; i < rows; ++i) {
      double sum = 0.0;
      for (Index k = 0; k < inner; ++k) sum += a(i, k) * b(k, j);
      out[j * rows + i] = sum;
    }
}

/// View of numbers as a matrix with this many rows.
struct View {
  Lane data;
  Index rows;
  double operator()(Index i, Index j) const { return data[j * rows + i]; }
};

/// Transposed view of a matrix.
template <class Of>
struct Transposed {
  const Of& of;
  double operator()(Index i, Index j) const { return of(j, i); }
};
template <class Of>
Transposed<Of> transposed(const Of& of) {
  return {of};
}

/// Replaces a symmetric positive definite matrix (n x n) by its Cholesky factor L in the lower triangle.
/// Returns false for a matrix that is not positive definite.
inline bool factorize(Index n, Lane s) {
  for (Index j = 0; j < n; ++j) {
    for (Index k = 0; k < j; ++k)
      for (Index i = j; i < n; ++i) s[j * n + i] -= s[k * n + i] * s[k * n + j];
    if (!(s[j * n + j] > 0.0)) return false;
    const double root = std::sqrt(s[j * n + j]);
    for (Index i = j; i < n; ++i) s[j * n + i] /= root;
  }
  return true;
}

/// Solves L L^T x = b in place; the elements of x are `stride` apart.
inline void solve_factorized(Index n, Lane l, Lane x, Index stride) {
  for (Index i = 0; i < n; ++i) {
    for (Index k = 0; k < i; ++k) x[i * stride] -= l[k * n + i] * x[k * stride];
    x[i * stride] /= l[i * n + i];
  }
  for (Index i = n - 1; i >= 0; --i) {
    for (Index k = i + 1; k < n; ++k) x[i * stride] -= l[i * n + k] * x[k * stride];
    x[i * stride] /= l[i * n + i];
  }
}

}  // namespace dense

/// Linear system of a block: dx/dt or x[k+1] = A x + B u, y = C x + D u. Its numbers have no units.
struct LinearSystem : Resettable {
  Matrix A, B, C, D;
  Input<> u{};
  bool direct = false;  // true if u is connected and D is not zero
};

/// Linear system with an observer of constant gain L.
struct LinearObserver : LinearSystem {
  Matrix L;
  Input<> measured{};
  Output<> estimate{};
};

}  // namespace stepwire
