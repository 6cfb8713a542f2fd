#include "engine/simulate/solve/tableau.hpp"

namespace stepwire::solve {

Tableau euler_tableau() {
  return {{}, {}, {1.0}};
}

Tableau heun_tableau() {
  return {{1.0}, {{1.0}}, {0.5, 0.5}};
}

Tableau bogacki_shampine_tableau() {
  return {{1.0 / 2, 3.0 / 4}, {{1.0 / 2}, {0.0, 3.0 / 4}}, {2.0 / 9, 1.0 / 3, 4.0 / 9}};
}

Tableau rk4_tableau() {
  return {{0.5, 0.5, 1.0}, {{0.5}, {0.0, 0.5}, {0.0, 0.0, 1.0}}, {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}};
}

Tableau dormand_prince_tableau() {
  return {{1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1.0},
          {{1.0 / 5},
           {3.0 / 40, 9.0 / 40},
           {44.0 / 45, -56.0 / 15, 32.0 / 9},
           {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
           {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656}},
          {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
}

}  // namespace stepwire::solve
