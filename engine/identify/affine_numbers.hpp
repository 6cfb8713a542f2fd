#pragma once

#include <cstddef>
#include <vector>

namespace stepwire {

/// Numbers that depend on some parameters in straight lines:
/// number = number at the start + sum over parameters of slope (value - start).
class AffineNumbers {
 public:
  /// The numbers after a change of one parameter.
  struct Probe {
    double change = 0.0;  ///< not 0
    std::vector<double> numbers;
  };

  /// `probes[j]` changes parameter j alone from where the numbers are `origin`, which are those at the start
  /// or some that move alike. All have one length.
  AffineNumbers(std::vector<double> start_values, std::vector<double> at_start,
                const std::vector<double>& origin, const std::vector<Probe>& probes);

  /// The numbers for these values of the parameters.
  std::vector<double> at(const std::vector<double>& values) const;
  /// Are these the numbers for these values, but for rounding?
  bool agrees(const std::vector<double>& values, const std::vector<double>& numbers) const;

 private:
  struct Moving {
    std::size_t place;
    std::vector<double> slopes;
  };

  std::vector<double> start_values_, at_start_;
  std::vector<Moving> moving_;
};

}  // namespace stepwire
