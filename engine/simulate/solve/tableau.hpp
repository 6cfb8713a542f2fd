#pragma once

#include <vector>

namespace stepwire::solve {

/// Explicit Runge-Kutta method: x_i = x + h sum_j a_ij k_j, k_i = f(t + c_i h, x_i), x' = x + h sum_i b_i
/// k_i.
struct Tableau {
  std::vector<double> c;               ///< times of the stages after the first
  std::vector<std::vector<double>> a;  ///< rows of the stages after the first
  std::vector<double> b;
};

Tableau euler_tableau();
/// Heun 1900: trapezoidal rule with an explicit end point.
Tableau heun_tableau();
/// Bogacki and Shampine 1989, Appl. Math. Lett. 2(4): third-order method of their pair.
Tableau bogacki_shampine_tableau();
/// Kutta 1901: classical fourth-order method.
Tableau rk4_tableau();
/// Dormand and Prince 1980, J. Comput. Appl. Math. 6(1): fifth-order method of their pair.
Tableau dormand_prince_tableau();

}  // namespace stepwire::solve
