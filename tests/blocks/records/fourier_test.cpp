#include "blocks/records/fourier.hpp"

#include <catch2/catch.hpp>

#include "engine/base/math/normal_quantile.hpp"

using namespace stepwire;
using Series = std::vector<std::complex<double>>;

namespace {

Series some_numbers(std::size_t count) {
  Series x(count);
  for (std::size_t n = 0; n < count; ++n)
    x[n] = {normal_quantile(to_unit_interval(random_bits(1, n))),
            normal_quantile(to_unit_interval(random_bits(2, n)))};
  return x;
}

}  // namespace

TEST_CASE("the fast transform is the defining sum for any number of samples") {
  for (std::size_t count : {1, 2, 3, 8, 12, 31, 64, 100}) {
    const Series x = some_numbers(count), spectrum = fourier(x), back = inverse_fourier(spectrum);
    for (std::size_t k = 0; k < count; ++k) {
      std::complex<double> sum;
      for (std::size_t n = 0; n < count; ++n)
        sum += x[n] *
               std::polar(1.0, -2.0 * M_PI * static_cast<double>(k * n % count) / static_cast<double>(count));
      REQUIRE(std::abs(spectrum[k] - sum) < 1e-12);
      REQUIRE(std::abs(back[k] - x[k]) < 1e-13);
    }
  }
}
