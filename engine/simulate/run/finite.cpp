#include "engine/simulate/run/finite.hpp"

#include <cstring>

namespace stepwire::run {

namespace {

/// Vector of four numbers, a type of both g++ and clang.
using Four = double __attribute__((vector_size(32)));

}  // namespace

// Multiplies each number by 0, which gives 0 for finite numbers and NaN for others, and sums the products; so
// no branch is needed. Four independent sums hide the latency of the addition. target_clones selects AVX2
// where the processor has it.
[[gnu::target_clones("avx2", "default")]] bool all_finite(const double* numbers, std::size_t count) {
  Four a{}, b{}, c{}, d{};
  std::size_t i = 0;
  for (; i + 16 <= count; i += 16) {
    Four read_a, read_b, read_c, read_d;
    std::memcpy(&read_a, numbers + i, sizeof(Four));
    std::memcpy(&read_b, numbers + i + 4, sizeof(Four));
    std::memcpy(&read_c, numbers + i + 8, sizeof(Four));
    std::memcpy(&read_d, numbers + i + 12, sizeof(Four));
    a += read_a * 0.0;
    b += read_b * 0.0;
    c += read_c * 0.0;
    d += read_d * 0.0;
  }
  for (; i + 4 <= count; i += 4) {
    Four read;
    std::memcpy(&read, numbers + i, sizeof(Four));
    a += read * 0.0;
  }
  double rest = 0.0;
  for (; i < count; ++i) rest += numbers[i] * 0.0;
  const Four sum = (a + b) + (c + d);
  return rest + sum[0] + sum[1] + sum[2] + sum[3] == 0.0;
}

}  // namespace stepwire::run
