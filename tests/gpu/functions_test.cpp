#include "engine/base/math/elementary.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "engine/simulate/device/c_library.hpp"
#include "engine/simulate/device/exponential.hpp"
#include "engine/simulate/device/trigonometric.hpp"

namespace stepwire::device {

namespace {

constexpr double far_angle = 1e14;  // beyond it angles are reduced in another way

bool are_same(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || std::memcmp(&a, &b, sizeof a) == 0;
}

/// Returns numbers of all sizes, and those at which functions change their ways.
std::vector<double> arguments(std::uint32_t seed) {
  std::vector<double> numbers{0.0,   1.0,  0.5,     2.0,  3.5,    5e-324, 1e-310,   1e300, 709.0,   710.5,
                              745.5, 15.0, 14.9999, 27.3, 18.715, 1e-8,   infinity, nan,   smallest};
  for (std::size_t i = 0, count = numbers.size(); i < count; ++i) numbers.push_back(-numbers[i]);
  std::mt19937_64 source(seed);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  for (int i = 0; i < 4000; ++i)
    for (const double size :
         {1.0, 30.0, 1000.0, 1e6, std::ldexp(1.0, static_cast<int>(source() % 2000) - 1000)})
      numbers.push_back(part(source) * size);
  return numbers;
}

/// Returns the first argument at which two functions differ; NaN if there is none.
template <class One, class Other>
double difference(const One& one, const Other& other, double limit = infinity) {
  for (const double x : arguments(1))
    if (!(std::abs(x) >= limit) && !are_same(one(x), other(x))) return x;
  return nan;
}

/// Returns the count of pairs of arguments at which two functions differ.
template <class One, class Other>
std::size_t differences(const One& one, const Other& other) {
  std::vector<double> x = arguments(1), y = arguments(2);
  std::shuffle(y.begin(), y.end(), std::mt19937(3));
  std::size_t count = 0;
  for (std::size_t i = 0; i < x.size(); ++i) count += are_same(one(x[i], y[i]), other(x[i], y[i])) ? 0 : 1;
  for (std::size_t i = 0; i < 38; ++i)
    for (std::size_t j = 0; j < 38; ++j) count += are_same(one(x[i], x[j]), other(x[i], x[j])) ? 0 : 1;
  return count;
}

}  // namespace

#define STEPWIRE_CHECK_SAME(name, limit) \
  CHECK(std::isnan(                      \
      difference([](double x) { return device::name(x); }, [](double x) { return fn::name(x); }, limit)));

TEST_CASE("functions of one number on a device have the bits of those on the processor"){
    STEPWIRE_CHECK_SAME(sin, far_angle) STEPWIRE_CHECK_SAME(cos, far_angle)
        STEPWIRE_CHECK_SAME(tan, far_angle) STEPWIRE_CHECK_SAME(asin, infinity)
            STEPWIRE_CHECK_SAME(acos, infinity) STEPWIRE_CHECK_SAME(atan, infinity)
                STEPWIRE_CHECK_SAME(sinh, infinity) STEPWIRE_CHECK_SAME(cosh, infinity)
                    STEPWIRE_CHECK_SAME(tanh, infinity) STEPWIRE_CHECK_SAME(exp, infinity)
                        STEPWIRE_CHECK_SAME(expm1, infinity) STEPWIRE_CHECK_SAME(log, infinity)
                            STEPWIRE_CHECK_SAME(log1p, infinity) STEPWIRE_CHECK_SAME(log2, infinity)
                                STEPWIRE_CHECK_SAME(log10, infinity) STEPWIRE_CHECK_SAME(cbrt, infinity)
                                    STEPWIRE_CHECK_SAME(erfc, infinity)}
#undef STEPWIRE_CHECK_SAME

TEST_CASE("functions of two numbers on a device have the bits of those on the processor") {
  CHECK(differences([](double x, double y) { return device::atan2(x, y); },
                    [](double x, double y) { return fn::atan2(x, y); }) == 0);
  CHECK(differences([](double x, double y) { return device::hypot(x, y); },
                    [](double x, double y) { return fn::hypot(x, y); }) == 0);
  CHECK(differences([](double x, double y) { return y == 2.0 ? x * x : device::pow(x, y); },
                    [](double x, double y) { return fn::pow(x, y); }) == 0);
}

TEST_CASE("sines of very large angles on a device differ by two units in the last place at most") {
  for (const double x : arguments(4)) {
    if (!std::isfinite(x) || std::abs(x) < far_angle) continue;
    INFO(x);
    const double limit = 2.0 * std::numeric_limits<double>::epsilon();
    CHECK(std::abs(device::sin(x) - fn::sin(x)) <= limit * std::abs(fn::sin(x)));
    CHECK(std::abs(device::cos(x) - fn::cos(x)) <= limit * std::abs(fn::cos(x)));
    CHECK(std::abs(device::tan(x) - fn::tan(x)) <= limit * std::abs(fn::tan(x)));
  }
}

TEST_CASE("functions of the C library on a device have the bits of those on the processor") {
  CHECK(differences([](double x, double y) { return device::nextafter(x, y); },
                    [](double x, double y) { return std::nextafter(x, y); }) == 0);
  CHECK(differences([](double x, double y) { return device::fmod(x, y); },
                    [](double x, double y) { return std::fmod(x, y); }) == 0);
  // The C library returns -0 for some divisors that are not normal; 0 has the sign of the dividend.
  CHECK(differences([](double x, double y) { return std::abs(device::remainder(x, y)); },
                    [](double x, double y) { return std::abs(std::remainder(x, y)); }) == 0);
  std::size_t wrong = 0;
  for (const double x : arguments(5)) {
    int one = 0, other = 0;
    wrong += are_same(device::frexp(x, &one), std::frexp(x, &other)) && (one == other || !std::isfinite(x))
                 ? 0
                 : 1;
    double whole = 0.0, same = 0.0;
    wrong += are_same(device::modf(x, &whole), std::modf(x, &same)) && are_same(whole, same) ? 0 : 1;
    if (std::abs(x) < 1e18) wrong += device::lround(x) == std::lround(x) ? 0 : 1;
    for (const int e : {-2400, -1100, -1074, -1022, -53, 0, 7, 1023, 1024, 2400})
      wrong += are_same(device::ldexp(x, e), std::ldexp(x, e)) ? 0 : 1;
  }
  CHECK(wrong == 0);
}

}  // namespace stepwire::device
