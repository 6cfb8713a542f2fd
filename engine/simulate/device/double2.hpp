#pragma once

// Arithmetic of two numbers whose sum carries about 106 bits, and bits of numbers, for the functions of a
// kernel. See functions.hpp.

#include <bit>
#include <cstdint>
#include <limits>

namespace stepwire::device {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double smallest = std::numeric_limits<double>::min();
inline constexpr double pi_high = 3.141592653589793116, pi_low = 1.2246467991473532072e-16;

inline std::uint64_t bits(double x) {
  return std::bit_cast<std::uint64_t>(x);
}
inline double number(std::uint64_t x) {
  return std::bit_cast<double>(x);
}
inline constexpr std::uint64_t sign_bit = std::uint64_t{1} << 63;

inline double size_of(double x) {
  return number(bits(x) & ~sign_bit);
}
inline double times_sign(double x, double of) {
  return number(bits(x) ^ (bits(of) & sign_bit));
}
inline bool is_infinite(double x) {
  return x == infinity || x == -infinity;
}
inline bool is_nan(double x) {
  return x != x;
}
inline double nearest(double x) {
  return __builtin_rint(x);
}
inline double towards_zero(double x) {
  return __builtin_trunc(x);
}
/// Returns a whole number as an integer; 0 for one beyond 2^30, where no result depends on it.
inline int integer(double x) {
  return size_of(x) < 1073741824.0 ? static_cast<int>(x) : 0;
}
inline int high_word(double x) {
  return static_cast<int>(static_cast<std::int64_t>(bits(x)) >> 32);
}
inline double power_of_two(int exponent) {
  return number(static_cast<std::uint64_t>(static_cast<std::int64_t>(0x3ff + exponent)) << 52);
}
/// Returns x * 2^exponent, in two products.
inline double scaled(double x, int exponent) {
  return x * power_of_two(exponent >> 1) * power_of_two(exponent - (exponent >> 1));
}
/// Returns x * 2^exponent by an addition to the exponent of x.
inline double shifted(double x, int exponent) {
  return number(bits(x) + (static_cast<std::uint64_t>(static_cast<std::int64_t>(exponent)) << 52));
}

/// Returns a polynomial by Estrin's scheme. The coefficients begin with that of the highest power; `powers`
/// are x, x^2, x^4 and x^8.
template <int count>
inline double estrin(const double* coefficients, const double* powers) {
  if constexpr (count == 1) {
    return *coefficients;
  } else {
    constexpr unsigned low = std::bit_floor(static_cast<unsigned>(count - 1));
    constexpr int rest = count - static_cast<int>(low);
    return powers[std::bit_width(low) - 1] * estrin<rest>(coefficients, powers) +
           estrin<static_cast<int>(low)>(coefficients + rest, powers);
  }
}
template <int count>
inline double polynomial(double x, const double (&coefficients)[count]) {
  const double x2 = x * x, x4 = x2 * x2, powers[] = {x, x2, x4, x4 * x4};
  return estrin<count>(coefficients, powers);
}

/// Sum of two numbers that carries about 106 bits.
struct Double2 {
  double x, y;
};

/// Returns the upper 26 bits of a number.
inline double upper(double x) {
  return number(bits(x) & 0xfffffffff8000000u);
}
inline Double2 negative(Double2 a) {
  return {-a.x, -a.y};
}
inline Double2 normalized(Double2 a) {
  const double s = a.x + a.y;
  return {s, a.x - s + a.y};
}
inline Double2 scale(Double2 a, double by) {
  return {a.x * by, a.y * by};
}
// Sums; those of add() require that the first number is the larger one.
inline Double2 add(double x, double y) {
  const double s = x + y;
  return {s, x - s + y};
}
inline Double2 add(Double2 x, double y) {
  const double s = x.x + y;
  return {s, x.x - s + y + x.y};
}
inline Double2 add(double x, Double2 y) {
  const double s = x + y.x;
  return {s, x - s + y.x + y.y};
}
inline Double2 add(Double2 x, Double2 y) {
  const double s = x.x + y.x;
  return {s, x.x - s + y.x + x.y + y.y};
}
inline Double2 add_any(double x, double y) {
  const double s = x + y, v = s - x;
  return {s, (x - (s - v)) + (y - v)};
}
inline Double2 add_any(Double2 x, double y) {
  const double s = x.x + y, v = s - x.x;
  return {s, (x.x - (s - v)) + (y - v) + x.y};
}
inline Double2 add_any(double x, Double2 y) {
  const double s = x + y.x, v = s - x;
  return {s, (x - (s - v)) + (y.x - v) + y.y};
}
inline Double2 add_any(Double2 x, Double2 y) {
  const double s = x.x + y.x, v = s - x.x;
  return {s, (x.x - (s - v)) + (y.x - v) + (x.y + y.y)};
}
inline Double2 subtract(Double2 x, double y) {
  const double s = x.x - y;
  return {s, x.x - s - y + x.y};
}
inline Double2 subtract(Double2 x, Double2 y) {
  const double s = x.x - y.x;
  return {s, x.x - s - y.x + x.y - y.y};
}
inline Double2 multiply(double x, double y) {
  const double xh = upper(x), xl = x - xh, yh = upper(y), yl = y - yh, s = x * y;
  return {s, xh * yh + -s + xl * yh + xh * yl + xl * yl};
}
inline Double2 multiply(Double2 x, double y) {
  const double xh = upper(x.x), xl = x.x - xh, yh = upper(y), yl = y - yh, s = x.x * y;
  return {s, xh * yh + -s + xl * yh + xh * yl + xl * yl + x.y * y};
}
inline Double2 multiply(Double2 x, Double2 y) {
  const double xh = upper(x.x), xl = x.x - xh, yh = upper(y.x), yl = y.x - yh, s = x.x * y.x;
  return {s, xh * yh + -s + xl * yh + xh * yl + xl * yl + x.x * y.y + x.y * y.x};
}
/// Returns a product as one number.
inline double product(Double2 x, Double2 y) {
  const double xh = upper(x.x), xl = x.x - xh, yh = upper(y.x), yl = y.x - yh;
  return x.y * yh + xh * y.y + xl * yl + xh * yl + xl * yh + xh * yh;
}
inline Double2 square(Double2 x) {
  const double xh = upper(x.x), xl = x.x - xh, s = x.x * x.x;
  return {s, xh * xh + -s + (xh + xh) * xl + xl * xl + x.x * (x.y + x.y)};
}
inline Double2 divide(Double2 n, Double2 d) {
  const double t = 1.0 / d.x;
  const double dh = upper(d.x), dl = d.x - dh, th = upper(t), tl = t - th, nh = upper(n.x), nl = n.x - nh;
  const double s = n.x * t;
  const double u =
      nh * th - s + nh * tl + nl * th + nl * tl + s * (1.0 - dh * th - dh * tl - dl * th - dl * tl);
  return {s, t * (n.y - s * d.y) + u};
}
inline Double2 reciprocal(double d) {
  const double t = 1.0 / d, dh = upper(d), dl = d - dh, th = upper(t), tl = t - th;
  return {t, t * (1.0 - dh * th - dh * tl - dl * th - dl * tl)};
}
inline Double2 reciprocal(Double2 d) {
  const double t = 1.0 / d.x, dh = upper(d.x), dl = d.x - dh, th = upper(t), tl = t - th;
  return {t, t * (1.0 - dh * th - dh * tl - dl * th - dl * tl - d.y * t)};
}
inline Double2 root(Double2 d) {
  const double t = __builtin_sqrt(d.x + d.y);
  return scale(multiply(add_any(d, multiply(t, t)), reciprocal(t)), 0.5);
}
inline Double2 root(double d) {
  const double t = __builtin_sqrt(d);
  return scale(multiply(add_any(d, multiply(t, t)), reciprocal(t)), 0.5);
}

}  // namespace stepwire::device
