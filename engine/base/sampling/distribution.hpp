#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace stepwire::sampling {

/// How a number is spread. All distributions but that of words are continuous; what they have is listed in
/// the order of `numbers`.
struct Distribution {
  enum class Kind {
    uniform,     ///< low, high
    normal,      ///< mean, standard deviation
    lognormal,   ///< median, coefficient of variation: standard deviation over mean
    triangular,  ///< low, mode, high
    words        ///< index of a word, by `weights`
  };
  Kind kind = Kind::uniform;
  std::array<double, 3> numbers{};
  std::vector<double> weights{};  ///< of words, each above 0; their sum counts as 1

  /// The number that a share of all samples stays below; the share is in (0, 1). The same bits on every
  /// machine.
  double quantile(double share) const;
};

}  // namespace stepwire::sampling
