#pragma once

// Functions of the C library that blocks call, each with one exact result, so a device gives the bits of the
// processor. A device has no library, so they are defined there under their names in C. Included by the text
// of kernels.

#include <cmath>
#include <cstdint>
#include <cstring>

#include "engine/simulate/device/double2.hpp"

namespace stepwire::device {

/// Whole number times a power of two: m * 2^(e - 1075), with 53 bits in m for a normal number.
struct Whole {
  std::uint64_t m;
  int e;
};
/// Takes a positive finite number apart, with bit 52 of m set.
inline Whole whole_of(double x) {
  const std::uint64_t fraction = bits(x) & 0xfffffffffffffu;
  const int e = static_cast<int>(bits(x) >> 52);
  if (e > 0) return {fraction | 0x10000000000000u, e};
  const int shift = __builtin_clzll(fraction) - 11;
  return {fraction << shift, 1 - shift};
}
/// Returns m * 2^(e - 1075) for m below 2^53, which is exact.
inline double number_of(std::uint64_t m, int e) {
  if (m == 0) return 0.0;
  const int shift = __builtin_clzll(m) - 11;
  m <<= shift;
  e -= shift;
  if (e <= 0) return number(m >> (1 - e));
  return number((m & 0xfffffffffffffu) | static_cast<std::uint64_t>(e) << 52);
}

/// Remainder of a division, and the last bit of its quotient.
struct Division {
  std::uint64_t rest;
  bool is_odd;
};
/// Divides x by y, for positive numbers with e of x not below that of y; the rest has the exponent of y.
inline Division division_of(Whole x, Whole y) {
  bool is_odd = false;
  for (int e = x.e;; --e) {
    is_odd = x.m >= y.m;
    if (is_odd) x.m -= y.m;
    if (e == y.e) return {x.m, is_odd};
    x.m <<= 1;
  }
}

inline double fmod(double x, double y) {
  const double size = size_of(x), divisor = size_of(y);
  if (divisor == 0.0 || is_infinite(x) || is_nan(x) || is_nan(y)) return nan;
  if (size < divisor) return x;
  const Whole of = whole_of(divisor);
  return times_sign(number_of(division_of(whole_of(size), of).rest, of.e), x);
}

inline double remainder(double x, double y) {
  const double size = size_of(x), divisor = size_of(y);
  if (divisor == 0.0 || is_infinite(x) || is_nan(x) || is_nan(y)) return nan;
  double rest = size;
  bool is_odd = false;
  if (size >= divisor) {
    const Whole of = whole_of(divisor);
    const Division division = division_of(whole_of(size), of);
    rest = number_of(division.rest, of.e);
    is_odd = division.is_odd;
  }
  // The difference is exact, and half of it is not needed, so small divisors lose no bits.
  const double other = divisor - rest;
  if (rest > other || (rest == other && is_odd)) rest = -other;
  return times_sign(rest, x);
}

inline double ldexp(double x, int exponent) {
  for (int i = 0; i < 2 && exponent > 1023; ++i, exponent -= 1023) x *= 0x1p1023;
  // A product that is not normal is rounded once: the steps before leave 53 bits.
  for (int i = 0; i < 2 && exponent < -1022; ++i, exponent += 969) x *= 0x1p-969;
  return x * power_of_two(exponent > 1023 ? 1023 : exponent < -1022 ? -1022 : exponent);
}

inline double frexp(double x, int* exponent) {
  *exponent = 0;
  if (x == 0.0 || is_infinite(x) || is_nan(x)) return x;
  const Whole whole = whole_of(size_of(x));
  *exponent = whole.e - 1022;
  return times_sign(number((whole.m & 0xfffffffffffffu) | std::uint64_t{1022} << 52), x);
}

inline double nextafter(double x, double to) {
  if (is_nan(x) || is_nan(to)) return nan;
  if (x == to) return to;
  if (x == 0.0) return times_sign(number(1), to);
  return number((x < to) == (x > 0.0) ? bits(x) + 1 : bits(x) - 1);
}

inline double modf(double x, double* whole) {
  *whole = __builtin_trunc(x);
  const double rest = is_infinite(x) ? 0.0 : x - *whole;
  return times_sign(size_of(rest), x);
}

/// Returns the nearest whole number; halves away from 0.
inline long lround(double x) {
  return static_cast<long>(__builtin_round(x));
}

inline int memcmp(const void* one, const void* other, std::size_t count) {
  const auto *a = static_cast<const unsigned char*>(one), *b = static_cast<const unsigned char*>(other);
  for (std::size_t i = 0; i < count; ++i)
    if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
  return 0;
}

}  // namespace stepwire::device

#ifdef __NVPTX__
// Nothing is allocated on a device: a call of operator new is left open, and its kernel is refused. So these
// have nothing to free.
inline void operator delete(void*) noexcept {}
inline void operator delete(void*, std::size_t) noexcept {}
inline void operator delete[](void*) noexcept {}
inline void operator delete[](void*, std::size_t) noexcept {}

extern "C" {
inline double fmod(double x, double y) noexcept {
  return stepwire::device::fmod(x, y);
}
inline double remainder(double x, double y) noexcept {
  return stepwire::device::remainder(x, y);
}
inline double ldexp(double x, int exponent) noexcept {
  return stepwire::device::ldexp(x, exponent);
}
inline double frexp(double x, int* exponent) noexcept {
  return stepwire::device::frexp(x, exponent);
}
inline double nextafter(double x, double to) noexcept {
  return stepwire::device::nextafter(x, to);
}
inline double modf(double x, double* whole) noexcept {
  return stepwire::device::modf(x, whole);
}
inline long lround(double x) noexcept {
  return stepwire::device::lround(x);
}
inline int memcmp(const void* one, const void* other, std::size_t count) noexcept {
  return stepwire::device::memcmp(one, other, count);
}
}
#endif
