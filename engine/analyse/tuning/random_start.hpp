#pragma once

#include <cstdint>
#include <random>
#include <vector>

namespace stepwire::tuning {

/// Returns uniform random shares of the bounds, 0 to 1. They depend on the arguments only and are the same on
/// any machine.
inline std::vector<double> random_shares(std::uint64_t seed, std::size_t number, std::size_t count,
                                         std::size_t attempt) {
  std::seed_seq words{seed, static_cast<std::uint64_t>(number), static_cast<std::uint64_t>(attempt)};
  std::mt19937_64 engine(words);
  std::vector<double> shares(count);
  for (double& share : shares) share = static_cast<double>(engine() >> 11u) * 0x1p-53;
  return shares;
}

}  // namespace stepwire::tuning
