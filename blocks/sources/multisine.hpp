#pragma once

#include <cmath>
#include <cstdint>

#include "blocks/sources/own_time.hpp"
#include "engine/base/math/elementary.hpp"

namespace stepwire {

/// Sum of cosines, y = sum_k a_k cos(2 pi f_k t + phi_k): a broadband excitation with a given spectrum.
struct Multisine : OwnTime {
  enum class Lines { all, odd };
  enum class Phase { schroeder, random, zero };

  double period = 1.0, lowest = 1.0, highest = 10.0, rms = 0.0;
  Lines lines = Lines::all;
  Numbers frequencies{}, amplitude{1.0}, phases{};
  Phase phase = Phase::schroeder;
  std::int64_t seed = 0;
  Output<1> y{};
  Numbers omega{}, a{}, phi{};  ///< of each line: 2 pi f [rad/s], amplitude, phase [rad]

  void outputs() {
    const double time = own();
    double sum = 0.0;
    for (Index k = 0; k < omega.size(); ++k) sum += a[k] * fn::cos(omega[k] * time + phi[k]);
    y = sum;
  }

  void update() { keep_origin(); }
  void configure(Configure& is);
  static void declare(Declare<Multisine>& is);

 private:
  void lay_lines(const Configure& is);
  void lay_amplitudes(const Configure& is);
  void lay_phases(const Configure& is);
};

}  // namespace stepwire
