#pragma once

// Trigonometric functions, their inverses and the error function of a kernel; see functions.hpp.

#include "engine/simulate/device/exponential.hpp"

namespace stepwire::device {

// Parts of pi whose products with the counts of half turns are exact.
inline constexpr double pi_a = 3.1415926218032836914, pi_b = 3.1786509424591713469e-08,
                        pi_c = 1.2246467864107188502e-16, pi_d = 1.2736634327021899816e-24;
inline constexpr double of_pi = 0.318309886183790671537767526745028724;
inline constexpr double short_range = 15.0, long_range = 1e+14;

/// Angle less whole quarter turns: from -pi/4 to pi/4, and the count of the quarters modulo 4.
struct Reduced {
  Double2 angle;
  int quarters;
};

/// Returns bits of 2/pi as words of 64, from a place after the binary point.
inline std::uint64_t word_of_two_by_pi(int first) {
  constexpr std::uint64_t words[] = {
      0xa2f9836e4e441529, 0xfc2757d1f534ddc0, 0xdb6295993c439041, 0xfe5163abdebbc561, 0xb7246e3a424dd2e0,
      0x06492eea09d1921c, 0xfe1deb1cb129a73e, 0xe88235f52ebb4484, 0xe99c7026b45f7e41, 0x3991d639835339f4,
      0x9c845f8bbdf9283b, 0x1ff897ffde05980f, 0xef2f118b5a0a6d1f, 0x6d367ecf27cb09b7, 0x4f463f669e5fea2d,
      0x7527bac7ebe5f17b, 0x3d0739f78a5292ea, 0x6bfb5fb11f8d5d08, 0x56033046fc7b6bab, 0xf0cfbc209af4361d};
  const int word = first >> 6, shift = first & 63;  // rounds down for places before the point
  const std::uint64_t high = word >= 0 ? words[word] : 0, low = word >= -1 ? words[word + 1] : 0;
  return shift == 0 ? high : (high << shift) | (low >> (64 - shift));
}

/// Returns a fraction of 128 bits, below a half, as a sum of two numbers.
inline Double2 fraction(std::uint64_t high, std::uint64_t low) {
  int zeros = 0;
  if (high == 0) {
    high = low;
    low = 0;
    zeros = 64;
  }
  if (high == 0) return {0.0, 0.0};
  const int more = __builtin_clzll(high);
  if (more > 0) {
    high = (high << more) | (low >> (64 - more));
    low <<= more;
  }
  zeros += more;
  const double first = static_cast<double>(high >> 11) * power_of_two(-53);
  const double second = static_cast<double>((high << 42 >> 11) | (low >> 22) >> 11) * power_of_two(-106);
  return {scaled(first, -zeros), scaled(second, -zeros)};
}

/// Reduces an angle beyond the long range with the bits of 2/pi that matter for it.
inline Reduced reduced_far(double a) {
  if (is_infinite(a) || is_nan(a)) return {{nan, nan}, 0};
  const std::uint64_t m = (bits(a) & 0xfffffffffffffu) | 0x10000000000000u;
  const int first = exponent_of(a) - 52 - 2;  // the first bit counts two quarters
  using Wide = unsigned __int128;
  const Wide low = static_cast<Wide>(m) * word_of_two_by_pi(first + 128);
  const Wide middle =
      static_cast<Wide>(m) * word_of_two_by_pi(first + 64) + static_cast<std::uint64_t>(low >> 64);
  const std::uint64_t top = m * word_of_two_by_pi(first) + static_cast<std::uint64_t>(middle >> 64);
  const auto next = static_cast<std::uint64_t>(middle), last = static_cast<std::uint64_t>(low);
  int quarters = static_cast<int>(top >> 62);
  std::uint64_t high = top << 2 | next >> 62, rest = next << 2 | last >> 62;
  const bool is_upper = (high >> 63) != 0;
  if (is_upper) {
    ++quarters;
    high = ~high;
    rest = ~rest;
  }
  Double2 angle = multiply(normalized(fraction(high, rest)), Double2{0.5 * pi_high, 0.5 * pi_low});
  if (is_upper != (a < 0.0)) angle = negative(angle);
  return {angle, (a < 0.0 ? -quarters : quarters) & 3};
}

/// Returns the angle d less q * pi / 2, or less q * pi, for q = high + low.
inline Double2 less_halves(Double2 s, double high, double low, double by) {
  s = add_any(s, high * (-pi_b * by));
  s = add_any(s, low * (-pi_b * by));
  s = add_any(s, high * (-pi_c * by));
  s = add_any(s, low * (-pi_c * by));
  return add(s, (high + low) * (-pi_d * by));
}

/// Returns the sine of an angle near 0.
inline double sine_of(Double2 angle) {
  const Double2 s = square(angle);
  double u = polynomial(
      s.x, {2.72052416138529567917983e-15, -7.6429259411395447190023e-13, 1.60589370117277896211623e-10,
            -2.5052106814843123359368e-08, 2.75573192104428224777379e-06, -0.000198412698412046454654947});
  u = u * s.x + 0.00833333333333318056201922;
  const Double2 x = add(1.0, multiply(add(-0.166666666666666657414808, u * s.x), s));
  return product(angle, x);
}

inline double sin(double d) {
  if (d == 0.0) return d;
  Double2 x;
  int half_turns;
  if (size_of(d) < short_range) {
    const double q = nearest(d * of_pi);
    half_turns = integer(q);
    x = add(q * -pi_high + d, q * -pi_low);
  } else if (size_of(d) < long_range) {
    const double high = towards_zero(d * (of_pi / 16777216.0)) * 16777216.0;
    const double low = nearest(d * of_pi - high);
    half_turns = integer(low);
    x = less_halves(add(high * -pi_a + d, low * -pi_a), high, low, 1.0);
  } else {
    const Reduced far = reduced_far(d);
    half_turns = ((far.quarters & 3) * 2 + (far.angle.x > 0.0 ? 2 : 1)) >> 2;
    const Double2 quarter{times_sign(-0.5 * pi_high, far.angle.x), times_sign(-0.5 * pi_low, far.angle.x)};
    x = normalized((far.quarters & 1) != 0 ? add_any(far.angle, quarter) : far.angle);
  }
  const double u = sine_of(x);
  return (half_turns & 1) != 0 ? -u : u;
}

/// Returns the angle of cos() for one of the long range, and the odd count of quarters.
inline Reduced quarters_of_cosine(double d) {
  double high = towards_zero(d * (of_pi / 8388608.0) + -of_pi / 16777216.0);
  const int whole = integer(nearest(d * of_pi + (high * -8388608.0 + -0.5)));
  high *= 16777216.0;
  const int odd = whole + whole + 1;
  const double low = odd;
  const Double2 s = add_any(high * (-pi_a * 0.5) + d, low * (-pi_a * 0.5));
  return {less_halves(s, high, low, 0.5), odd};
}

inline double cos(double d) {
  Double2 x;
  int quarters;
  if (size_of(d) < short_range) {
    const double q = 2.0 * nearest(d * of_pi + -0.5) + 1.0;
    quarters = integer(q);
    x = add(add_any(d, q * (-pi_high * 0.5)), q * (-pi_low * 0.5));
  } else if (size_of(d) < long_range) {
    const Reduced reduced = quarters_of_cosine(d);
    quarters = reduced.quarters;
    x = reduced.angle;
  } else {
    const Reduced far = reduced_far(d);
    quarters = ((far.quarters & 3) * 2 + (far.angle.x > 0.0 ? 8 : 7)) >> 1;
    const double y = far.angle.x > 0.0 ? 0.0 : -1.0;
    const Double2 quarter{times_sign(-0.5 * pi_high, y), times_sign(-0.5 * pi_low, y)};
    x = normalized((far.quarters & 1) == 0 ? add_any(far.angle, quarter) : far.angle);
  }
  const double u = sine_of(x);
  return (quarters & 2) == 0 ? -u : u;
}

/// Returns the angle of tan() for one of the long range, and the count of quarters.
inline Reduced quarters_of_tangent(double d) {
  const double high = towards_zero(d * (2.0 * of_pi / 16777216.0)) * 16777216.0;
  const Double2 s = add_any(multiply(Double2{0.63661977236758138243, -3.9357353350364971764e-17}, d),
                            (d < 0.0 ? -0.5 : 0.5) - high);
  const double low = towards_zero(s.x + s.y);
  const Double2 x = add(high * (-pi_a * 0.5) + d, low * (-pi_a * 0.5));
  return {less_halves(x, high, low, 0.5), integer(low)};
}

/// Returns the tangent of an angle near 0, or the negative of its reciprocal.
inline double tangent_of(Reduced reduced) {
  const Double2 t = scale(reduced.angle, 0.5), s = square(t);
  double u = polynomial(s.x, {+0.3245098826639276316e-3, +0.5619219738114323735e-3, +0.1460781502402784494e-2,
                              +0.3591611540792499519e-2, +0.8863268409563113126e-2, +0.2186948728185535498e-1,
                              +0.5396825399517272970e-1, +0.1333333333330500581e+0});
  u = u * s.x + +0.3333333333333343695e+0;
  const Double2 x = add(t, multiply(multiply(s, t), u));
  const Double2 y = add(-1.0, square(x)), z = scale(x, -2.0);
  const bool is_odd = (reduced.quarters & 1) != 0;
  const Double2 result = is_odd ? divide(negative(y), z) : divide(z, y);
  return result.x + result.y;
}

inline double tan(double d) {
  if (d == 0.0) return d;
  if (size_of(d) < short_range) {
    const double q = nearest(d * (2.0 * of_pi));
    return tangent_of({add(q * (-pi_high * 0.5) + d, q * (-pi_low * 0.5)), integer(q)});
  }
  return tangent_of(size_of(d) < long_range ? quarters_of_tangent(d) : reduced_far(d));
}

/// Returns the angle of the point (x, y), for y that is not negative.
inline Double2 angle_of(Double2 y, Double2 x) {
  int quarters = (bits(x.x) & sign_bit) != 0 ? -2 : 0;
  if (x.x < 0.0) x = negative(x);
  const bool is_steep = x.x < y.x;
  if (is_steep) ++quarters;
  const Double2 s = is_steep ? divide(negative(x), y) : divide(y, x);
  const Double2 t = normalized(square(s));
  double u = polynomial(
      t.x, {1.06298484191448746607415e-05, -0.000125620649967286867384336, 0.00070557664296393412389774,
            -0.00251865614498713360352999, 0.00646262899036991172313504, -0.0128281333663399031014274,
            0.0208024799924145797902497, -0.0289002344784740315686289, 0.0359785005035104590853656,
            -0.041848579703592507506027, 0.0470843011653283988193763, -0.0524914210588448421068719,
            0.0587946590969581003860434, -0.0666620884778795497194182, 0.0769225330296203768654095,
            -0.0909090442773387574781907});
  for (const double c : {0.111111108376896236538123, -0.142857142756268568062339, 0.199999999997977351284817,
                         -0.333333333333317605173818})
    u = u * t.x + c;
  const Double2 angle = add(s, multiply(multiply(s, t), u));
  const Double2 quarter{1.570796326794896557998982, 6.12323399573676603586882e-17};
  return add(multiply(quarter, static_cast<double>(quarters)), angle);
}

inline double atan(double d) {
  if (is_infinite(d)) return times_sign(1.570796326794896557998982, d);
  const Double2 angle = angle_of({size_of(d), 0.0}, {1.0, 0.0});
  return times_sign(angle.x + angle.y, d);
}

/// Returns 0 for a finite x, else `infinite` with the sign of x.
inline double if_infinite(double x, double infinite) {
  return is_infinite(x) ? number(bits(infinite) | (bits(x) & sign_bit)) : 0.0;
}

inline double atan2(double y, double x) {
  if (is_nan(x) || is_nan(y)) return nan;
  if (size_of(x) < 5.5626846462680083984e-309) {
    x *= 9007199254740992.0;
    y *= 9007199254740992.0;
  }
  const Double2 angle = angle_of({size_of(y), 0.0}, {x, 0.0});
  constexpr double quarter = 0.5 * pi_high, eighth = 0.25 * pi_high;
  double r = times_sign(angle.x + angle.y, x);
  if (is_infinite(x) || x == 0.0) r = quarter - if_infinite(x, times_sign(quarter, x));
  if (is_infinite(y)) r = quarter - if_infinite(x, times_sign(eighth, x));
  if (y == 0.0) r = (bits(x) & sign_bit) != 0 ? pi_high : 0.0;
  return times_sign(r, y);
}

/// Argument of an inverse sine or cosine, reduced, and the value of their series.
struct Arc {
  Double2 x;
  double u;
  bool is_small;
};
inline Arc arc_of(double d) {
  const double size = size_of(d);
  const bool is_small = size < 0.5;
  const double x2 = is_small ? d * d : (1.0 - size) * 0.5;
  Double2 x = is_small ? Double2{size, 0.0} : root(x2);
  if (size == 1.0) x = {0.0, 0.0};
  const double u =
      polynomial(x2, {+0.3161587650653934628e-1, -0.1581918243329996643e-1, +0.1929045477267910674e-1,
                      +0.6606077476277170610e-2, +0.1215360525577377331e-1, +0.1388715184501609218e-1,
                      +0.1735956991223614604e-1, +0.2237176181932048341e-1, +0.3038195928038132237e-1,
                      +0.4464285681377102438e-1, +0.7500000000378581611e-1, +0.1666666666666497543e+0});
  return {x, u * (x2 * x.x), is_small};
}

inline double asin(double d) {
  const Arc arc = arc_of(d);
  const Double2 y = subtract(subtract(Double2{0.25 * pi_high, 0.25 * pi_low}, arc.x), arc.u);
  return times_sign(arc.is_small ? arc.u + arc.x.x : (y.x + y.y) * 2.0, d);
}

inline double acos(double d) {
  const Arc arc = arc_of(d);
  const Double2 sum = add(times_sign(arc.x.x, d), times_sign(arc.u, d));
  Double2 y = subtract(Double2{0.5 * pi_high, 0.5 * pi_low}, sum);
  if (!arc.is_small) {
    y = scale(add(arc.x, arc.u), 2.0);
    if (d < 0.0) y = subtract(Double2{pi_high, pi_low}, y);
  }
  return y.x + y.y;
}

/// Coefficients of the complementary error function in one of its four ranges: those of the series, and
/// three sums of two numbers.
struct ErrorSeries {
  double series[18];
  Double2 last[3];
};
inline constexpr ErrorSeries error_series[] = {
    {{+0.6801072401395386139e-20, -0.2161766247570055669e-18, +0.4695919173301595670e-17,
      -0.9049140419888007122e-16, +0.1634018903557410728e-14, -0.2783485786333451745e-13,
      +0.4463221276786415752e-12, -0.6711366622850136563e-11, +0.9422759050232662223e-10,
      -0.1229055530100229098e-08, +0.1480719281585086512e-07, -0.1636584469123399803e-06,
      +0.1646211436588923575e-05, -0.1492565035840623511e-04, +0.1205533298178967851e-03,
      -0.8548327023450850081e-03, +0.5223977625442187932e-02, -0.2686617064513125222e-01},
     {{0.11283791670955126141, -4.0175691625932118483e-18},
      {-0.37612638903183753802, 1.3391897206042552387e-17},
      {1.1283791670955125586, 1.5335459613165822674e-17}}},
    {{+0.3438010341362585303e-12, -0.1237021188160598264e-10, +0.2117985839877627852e-09,
      -0.2290560929177369506e-08, +0.1748931621698149538e-07, -0.9956602606623249195e-07,
      +0.4330010240640327080e-06, -0.1435050600991763331e-05, +0.3460139479650695662e-05,
      -0.4988908180632898173e-05, -0.1308775976326352012e-05, +0.2825086540850310103e-04,
      -0.6393913713069986071e-04, -0.2566436514695078926e-04, +0.5895792375659440364e-03,
      -0.1695715579163588598e-02, +0.2089116434918055149e-03, +0.1912855949584917753e-01},
     {{-0.10277263343147646779, -6.2338714083404900225e-18},
      {-0.63661976742916359662, 7.6321019159085724662e-18},
      {-1.1283791674717296161, 8.0896847755965377194e-17}}},
    {{-0.5757819536420710449e+2, +0.4669289654498104483e+3, -0.1796329879461355858e+4,
      +0.4355892193699575728e+4, -0.7456258884965764992e+4, +0.9553977358167021521e+4,
      -0.9470019905444229153e+4, +0.7387344321849855078e+4, -0.4557713054166382790e+4,
      +0.2207866967354055305e+4, -0.8217975658621754746e+3, +0.2268659483507917400e+3,
      -0.4633361260318560682e+2, +0.9557380123733945965e+1, -0.2958429331939661289e+1,
      +0.1670329508092765480e+0, +0.6096615680115419211e+0, +0.1059212443193543585e-2},
     {{-0.50005180473999022439, 2.6362140569041995803e-17},
      {1.601106273924963368e-06, 1.1974001857764476775e-23},
      {-0.57236496645145429341, 3.0704553245872027258e-17}}},
    {{+0.2334249729638701319e+5, -0.4695661044933107769e+5, +0.3173403108748643353e+5,
      +0.3242982786959573787e+4, -0.2014717999760347811e+5, +0.1554006970967118286e+5,
      -0.6150874190563554293e+4, +0.1240047765634815732e+4, -0.8210325475752699731e+2,
      +0.3242443880839930870e+2, -0.2923418863833160586e+2, +0.3457461732814383071e+0,
      +0.5489730155952392998e+1, +0.1559934132251294134e-2, -0.1541741566831520638e+1,
      +0.2823152230558364186e-5, +0.6249999184195342838e+0, +0.1741749416408701288e-8},
     {{-0.5000000000258444377, -4.0074044712386992281e-17},
      {2.3761973137523364792e-13, -1.1670076950531026582e-29},
      {-0.57236494292470108114, -2.3984352208056898003e-17}}},
};

inline double erfc(double s) {
  if (is_nan(s)) return nan;
  const double a = size_of(s);
  const int range = a < 1.0 ? 0 : a < 2.2 ? 1 : a < 4.2 ? 2 : 3;
  const Double2 u = range == 0   ? multiply(a, a)
                    : range == 1 ? Double2{a, 0.0}
                                 : divide(Double2{1.0, 0.0}, Double2{a, 0.0});
  const ErrorSeries& of = error_series[range];
  double t = of.series[0];
  for (int i = 1; i < 18; ++i) t = t * u.x + of.series[i];
  Double2 d = add_any(multiply(u, t), of.last[0]);
  d = add_any(multiply(d, u), of.last[1]);
  d = add_any(multiply(d, u), of.last[2]);
  Double2 x = multiply(range < 2 ? d : Double2{-a, 0.0}, a);
  if (range >= 2) x = add_any(x, d);
  x = range == 0 ? subtract(Double2{1.0, 0.0}, x) : exp2_of(x);
  if (range >= 2) x = multiply(x, u);
  const double r = a < 27.3 ? x.x + x.y : 0.0;
  return (bits(s) & sign_bit) != 0 ? 2.0 - r : r;
}

}  // namespace stepwire::device
