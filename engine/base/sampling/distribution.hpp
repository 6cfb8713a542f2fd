#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace stepwire::sampling {

/// Probability distribution of a number. The order of `numbers` is listed with each kind. All kinds but
/// `words` are continuous.
struct Distribution {
  enum class Kind {
    uniform,     ///< low, high
    normal,      ///< mean, standard deviation
    lognormal,   ///< median, coefficient of variation: standard deviation over mean
    triangular,  ///< low, mode, high
    words        ///< index of a word, drawn by `weights`
  };
  Kind kind = Kind::uniform;
  std::array<double, 3> numbers{};
  std::vector<double> weights{};  ///< of words, each above 0; normalised by their sum

  /// Returns the quantile of a probability in (0, 1), with the same bits on every machine.
  double quantile(double share) const;
};

}  // namespace stepwire::sampling
