#pragma once

// Exponentials, logarithms, powers and roots of a kernel; see functions.hpp.

#include <initializer_list>

#include "engine/simulate/device/double2.hpp"

namespace stepwire::device {

inline constexpr double ln2_high = .69314718055966295651160180568695068359375;
inline constexpr double ln2_low = .28235290563031577122588448175013436025525412068e-12;
inline constexpr double of_ln2 = 1.442695040888963407359924681001892137426645954152985934135449406931;
inline constexpr double largest_exponent = 709.78271114955742909217217426;
inline constexpr Double2 ln2{0.693147180559945286226764, 2.319046813846299558417771e-17};

inline double exp(double d) {
  const double u = nearest(d * of_ln2);
  double s = u * -ln2_high + d;
  s = u * -ln2_low + s;
  double p = polynomial(
      s, {2.08860621107283687536341e-09, 2.51112930892876518610661e-08, 2.75573911234900471893338e-07,
          2.75572362911928827629423e-06, 2.4801587159235272998791e-05, 0.000198412698960509205564975,
          0.00138888888889774492207962, 0.00833333333331652721664984, 0.0416666666666665047591422,
          0.166666666666666851703837});
  p = p * s + 0.5;
  p = scaled(1.0 + (s * s * p + s), integer(u));
  if (d > largest_exponent) p = infinity;
  return d < -1000.0 ? 0.0 : p;
}

/// Returns the exponential of a sum of two numbers.
inline double exp_of(Double2 d) {
  const double q = nearest((d.x + d.y) * of_ln2);
  Double2 s = add_any(d, q * -ln2_high);
  s = normalized(add_any(s, q * -ln2_low));
  const double u = polynomial(
      s.x, {2.51069683420950419527139e-08, 2.76286166770270649116855e-07, 2.75572496725023574143864e-06,
            2.48014973989819794114153e-05, 0.000198412698809069797676111, 0.0013888888939977128960529,
            0.00833333333332371417601081, 0.0416666666665409524128449, 0.166666666666666740681535,
            0.500000000000000999200722});
  Double2 t = add(1.0, s);
  t = add(t, multiply(square(s), u));
  return d.x < -1000.0 ? 0.0 : scaled(t.x + t.y, integer(q));
}

/// Returns the same as a sum of two numbers.
inline Double2 exp2_of(Double2 d) {
  const double q = nearest((d.x + d.y) * of_ln2);
  Double2 s = add_any(d, q * -ln2_high);
  s = add_any(s, q * -ln2_low);
  const Double2 s2 = square(s), s4 = square(s2);
  const double powers[] = {s.x, s2.x, s4.x, s4.x * s4.x};
  constexpr double coefficients[] = {+0.1602472219709932072e-9, +0.2092255183563157007e-8,
                                     +0.2505230023782644465e-7, +0.2755724800902135303e-6,
                                     +0.2755731892386044373e-5, +0.2480158735605815065e-4,
                                     +0.1984126984148071858e-3, +0.1388888888886763255e-2,
                                     +0.8333333333333347095e-2, +0.4166666666666669905e-1};
  Double2 t = add(0.5, multiply(s, +0.1666666666666666574e+0));
  t = add(1.0, multiply(t, s));
  t = add(1.0, multiply(t, s));
  t = add(t, multiply(s4, estrin<10>(coefficients, powers)));
  if (d.x < -1000.0) return {0.0, 0.0};
  return {scaled(t.x, integer(q)), scaled(t.y, integer(q))};
}

inline double sinh(double x) {
  if (is_nan(x)) return nan;
  Double2 d = exp2_of({size_of(x), 0.0});
  d = subtract(d, reciprocal(d));
  const double y = (d.x + d.y) * 0.5;
  return times_sign(size_of(x) > 710.0 || is_nan(y) ? infinity : y, x);
}

inline double cosh(double x) {
  if (is_nan(x)) return nan;
  Double2 d = exp2_of({size_of(x), 0.0});
  d = add(d, reciprocal(d));
  const double y = (d.x + d.y) * 0.5;
  return size_of(x) > 710.0 || is_nan(y) ? infinity : y;
}

inline double tanh(double x) {
  if (is_nan(x)) return nan;
  Double2 d = exp2_of({size_of(x), 0.0});
  const Double2 e = reciprocal(d);
  d = divide(add_any(d, negative(e)), add_any(d, e));
  const double y = d.x + d.y;
  return times_sign(size_of(x) > 18.714973875 || is_nan(y) ? 1.0 : y, x);
}

inline double expm1(double x) {
  if (x == 0.0) return x;
  const Double2 d = add_any(exp2_of({x, 0.0}), -1.0);
  if (x > 709.782712893383996732223) return infinity;
  return x < -36.736800569677101399113302437 ? -1.0 : d.x + d.y;
}

/// Number as m * 2^e, with m from 0.75 to 1.5.
struct Parts {
  double m;
  int e;
};
inline int exponent_of(double x) {
  return static_cast<int>((bits(x) >> 52) & 0x7ff) - 0x3ff;
}
inline Parts parts_of(double& d) {
  const bool is_small = d < smallest;
  if (is_small) d *= 18446744073709551616.0;
  const int e = exponent_of(d * (1.0 / 0.75));
  return {shifted(d, -e), is_small ? e - 64 : e};
}

/// Returns the result of a logarithm of d, whose regular value is `r`.
inline double log_result(double d, double r) {
  if (d == infinity) r = infinity;
  if (d < 0.0 || is_nan(d)) r = nan;
  return d == 0.0 ? -infinity : r;
}

inline double log(double d) {
  const Parts parts = parts_of(d);
  const Double2 x = divide(add_any(-1.0, parts.m), add_any(1.0, parts.m));
  const double x2 = x.x * x.x;
  const double t =
      polynomial(x2, {0.1532076988502701353e+0, 0.1525629051003428716e+0, 0.1818605932937785996e+0,
                      0.2222214519839380009e+0, 0.2857142932794299317e+0, 0.3999999999635251990e+0,
                      0.6666666666667333541e+0});
  Double2 s = multiply(ln2, static_cast<double>(parts.e));
  s = add(s, scale(x, 2.0));
  s = add(s, x2 * x.x * t);
  return log_result(d, s.x + s.y);
}

inline double log10(double d) {
  const Parts parts = parts_of(d);
  const Double2 x = divide(add_any(-1.0, parts.m), add_any(1.0, parts.m));
  const double x2 = x.x * x.x;
  const double t =
      polynomial(x2, {+0.6653725819576758460e-1, +0.6625722782820833712e-1, +0.7898105214313944078e-1,
                      +0.9650955035715275132e-1, +0.1240841409721444993e+0, +0.1737177927454605086e+0,
                      +0.2895296546021972617e+0});
  Double2 s =
      multiply(Double2{0.30102999566398119802, -2.803728127785170339e-18}, static_cast<double>(parts.e));
  s = add(s, multiply(x, Double2{0.86858896380650363334, 1.1430059694096389311e-17}));
  s = add(s, x2 * x.x * t);
  return log_result(d, s.x + s.y);
}

inline double log2(double d) {
  const Parts parts = parts_of(d);
  const Double2 x = divide(add_any(-1.0, parts.m), add_any(1.0, parts.m));
  const double x2 = x.x * x.x;
  const double t =
      polynomial(x2, {+0.2211941750456081490e+0, +0.2200768693152277689e+0, +0.2623708057488514656e+0,
                      +0.3205977477944495502e+0, +0.4121985945485324709e+0, +0.5770780162997058982e+0,
                      +0.96179669392608091449});
  Double2 s = add_any(static_cast<double>(parts.e),
                      multiply(x, Double2{2.885390081777926774, 6.0561604995516736434e-18}));
  s = add_any(s, x2 * x.x * t);
  return log_result(d, s.x + s.y);
}

inline double log1p(double d) {
  if (d == 0.0) return d;
  double one_more = d + 1.0;
  const bool is_small = one_more < smallest;
  if (is_small) one_more *= 18446744073709551616.0;
  const int e = exponent_of(one_more * (1.0 / 0.75));
  const double u = shifted(1.0, -e), m = d * u + (u - 1.0);
  Double2 s = multiply(ln2, static_cast<double>(is_small ? e - 64 : e));
  const Double2 x = divide(Double2{m, 0.0}, add(2.0, m));
  const double x2 = x.x * x.x;
  const double t =
      polynomial(x2, {0.1532076988502701353e+0, 0.1525629051003428716e+0, 0.1818605932937785996e+0,
                      0.2222214519839380009e+0, 0.2857142932794299317e+0, 0.3999999999635251990e+0,
                      0.6666666666667333541e+0});
  s = add(s, scale(x, 2.0));
  s = add(s, x2 * x.x * t);
  if (d > 1e+307) return infinity;
  if (d < -1.0 || is_nan(d)) return nan;
  return d == -1.0 ? -infinity : s.x + s.y;
}

/// Returns the logarithm as a sum of two numbers.
inline Double2 log_of(double d) {
  const Parts parts = parts_of(d);
  Double2 x = divide(add_any(-1.0, parts.m), add_any(1.0, parts.m));
  const Double2 x2 = square(x);
  const double t =
      polynomial(x2.x, {0.116255524079935043668677, 0.103239680901072952701192, 0.117754809412463995466069,
                        0.13332981086846273921509, 0.153846227114512262845736, 0.181818180850050775676507,
                        0.222222222230083560345903, 0.285714285714249172087875, 0.400000000000000077715612});
  Double2 s = multiply(ln2, static_cast<double>(parts.e));
  s = add(s, scale(x, 2.0));
  x = multiply(x2, x);
  s = add(s, multiply(x, Double2{0.666666666666666629659233, 3.80554962542412056336616e-17}));
  x = multiply(x2, x);
  return add(s, multiply(x, t));
}

/// Returns the power of a finite number that is not 0, with a finite exponent.
inline double regular_power(double x, double y, bool is_whole, bool is_odd) {
  const Double2 d = multiply(log_of(size_of(x)), y);
  const double power = d.x > largest_exponent ? infinity : exp_of(d);
  return power * (x > 0.0 ? 1.0 : is_whole ? (is_odd ? -1.0 : 1.0) : nan);
}

inline double pow(double x, double y) {
  if (y == 0.0 || x == 1.0) return 1.0;
  if (is_nan(x) || is_nan(y)) return nan;
  const bool is_whole = towards_zero(y) == y;
  const bool is_odd = is_whole && size_of(y) < 9007199254740992.0 && towards_zero(y * 0.5) != y * 0.5;
  if (is_infinite(x) || x == 0.0) {
    const bool is_zero = (x == 0.0 ? -y : y) < 0.0;
    return (is_odd ? times_sign(1.0, x) : 1.0) * (is_zero ? 0.0 : infinity);
  }
  if (!is_infinite(y)) return regular_power(x, y, is_whole, is_odd);
  const double more = times_sign(size_of(x) - 1.0, y);
  if (more < 0.0) return 0.0;
  return more == 0.0 ? 1.0 : infinity;
}

/// Returns the cube root of 2 to the power 0, 1 or 2, with the sign of d.
inline Double2 third_of_exponent(int rest, double d) {
  Double2 q{1.0, 0.0};
  if (rest == 1) q = {1.2599210498948731907, -2.5899333753005069177e-17};
  if (rest == 2) q = {1.5874010519681995834, -1.0869008194197822986e-16};
  return {times_sign(q.x, d), times_sign(q.y, d)};
}

inline double cbrt(double d) {
  if (is_infinite(d) || d == 0.0) return d;
  const bool is_small = size_of(d) < 4.9090934652977266E-91;
  const double large = is_small ? 2.037035976334486E90 * size_of(d) : size_of(d);
  const int e = static_cast<int>((bits(large) >> 52) & 0x7ff) - (is_small ? 300 + 0x3ff : 0x3ff) + 1;
  d = scaled(d, -e);
  const double sum = static_cast<double>(e) + 6144.0;
  const int third = integer(towards_zero(sum * (1.0 / 3.0)));
  const Double2 q = third_of_exponent(integer(towards_zero(sum - static_cast<double>(third) * 3.0)), d);
  d = size_of(d);
  double x = -0.640245898480692909870982;
  for (const double c : {2.96155103020039511818595, -5.73353060922943847636166, 6.03990368989458747961407,
                         -3.85841935510444988821632, 2.2307275302496609725722})
    x = x * d + c;
  double y = x * x;
  y = y * y;
  x = x - (d * y - x) * (1.0 / 3.0);
  Double2 u = multiply(x, x);
  u = add_any(multiply(multiply(u, u), d), -x);
  y = -2.0 / 3.0 * (u.x + u.y) * x;
  Double2 v = multiply(add_any(multiply(x, x), y), d);
  v = multiply(v, q);
  return scaled(v.x + v.y, third - 2048);
}

inline double hypot(double x, double y) {
  x = size_of(x);
  y = size_of(y);
  if (x == infinity || y == infinity) return infinity;
  if (is_nan(x) || is_nan(y)) return nan;
  const double low = x < y ? x : y, high = x > y ? x : y;
  if (low == 0.0) return high;
  const double factor = high < smallest ? 18014398509481984.0 : 1.0;
  Double2 t = divide(Double2{low * factor, 0.0}, Double2{high * factor, 0.0});
  t = multiply(root(add_any(square(t), 1.0)), high);
  const double length = t.x + t.y;
  return is_nan(length) ? infinity : length;
}

}  // namespace stepwire::device
