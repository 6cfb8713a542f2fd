#pragma once

// Elementary functions of runs, which have the same bits on every machine. Those of a C library differ
// between its versions, and in one version by the instructions of the processor. These are the deterministic
// ones of SLEEF, declared here under the names of their symbols (Shibata, Petrogalli: SLEEF: a portable
// vectorized library of C standard mathematical functions, 2020). They give one number the same bits as 2, 4
// or 8 at once.
//
// Blocks, formulas and solvers call fn::sin(x) instead of std::sin(x). Operations with one exact result, such
// as std::sqrt, std::floor, std::fmod and std::ldexp, are those of the standard library.
//
// In the interpreter a call takes SLEEF's function or that of the C library, by the key `functions` of the
// file (see Selection). Generated code has one of them only: with STEPWIRE_LIBM that of the C library, else
// with STEPWIRE_SLEEF that of SLEEF. With STEPWIRE_LANES, GCC replaces a call of SLEEF in a loop over lanes
// by one call for 2, 4 or 8 of them. GCC forms the name of that function from the name of the scalar one, and
// each such name is an alias of SLEEF's.

#include <bit>
#include <cmath>
#include <cstdint>

namespace stepwire {

namespace fn {

// Functions of one number and of two, except pow. The text is the bound of their error in SLEEF: u10 is 1.0
// ulp, u15 is 1.5 and u05 is 0.5. SLEEF's sinh and cosh are infinite beyond 709.78.
#define STEPWIRE_FUNCTIONS(OF_ONE, OF_TWO) \
  OF_ONE(sin, "u10")                       \
  OF_ONE(cos, "u10")                       \
  OF_ONE(tan, "u10")                       \
  OF_ONE(asin, "u10")                      \
  OF_ONE(acos, "u10")                      \
  OF_ONE(atan, "u10")                      \
  OF_ONE(sinh, "u10")                      \
  OF_ONE(cosh, "u10")                      \
  OF_ONE(tanh, "u10")                      \
  OF_ONE(exp, "u10")                       \
  OF_ONE(expm1, "u10")                     \
  OF_ONE(log, "u10")                       \
  OF_ONE(log1p, "u10")                     \
  OF_ONE(log2, "u10")                      \
  OF_ONE(log10, "u10")                     \
  OF_ONE(cbrt, "u10")                      \
  OF_ONE(erfc, "u15")                      \
  OF_TWO(atan2, "u10")                     \
  OF_TWO(hypot, "u05")

#ifndef STEPWIRE_LIBM

// On x86-64 the form for 2 numbers is faster than the one for 1. Functions of a double and of two doubles
// both take and return the lower half of a register; the upper half has no effect on it.
#if defined(__x86_64__) && defined(__SSE4_1__)
#define STEPWIRE_SYMBOL(name, error) "Sleef_cinz_" #name "d2_" error "sse4"
#elif defined(__x86_64__)
#define STEPWIRE_SYMBOL(name, error) "Sleef_cinz_" #name "d2_" error "sse2"
#else
#define STEPWIRE_SYMBOL(name, error) "Sleef_cinz_" #name "d1_" error "purec"
#endif

#if defined(STEPWIRE_LANES) && defined(__x86_64__)
#define STEPWIRE_ATTRIBUTES __attribute__((const, simd("notinbranch")))
#define STEPWIRE_ALIAS(prefix, name, error, form) \
  asm(".set " prefix "_" STEPWIRE_SYMBOL(name, error) ", Sleef_cinz_" #name form);
#else
#define STEPWIRE_ATTRIBUTES __attribute__((const))
#define STEPWIRE_ALIAS(prefix, name, error, form)
#endif
#ifdef __AVX__
#define STEPWIRE_ALIAS_OF_4(prefix, name, error, form) STEPWIRE_ALIAS(prefix, name, error, form)
#else
#define STEPWIRE_ALIAS_OF_4(prefix, name, error, form)
#endif
#ifdef __AVX512F__
#define STEPWIRE_ALIAS_OF_8(prefix, name, error, form) STEPWIRE_ALIAS(prefix, name, error, form)
#else
#define STEPWIRE_ALIAS_OF_8(prefix, name, error, form)
#endif

#define STEPWIRE_ALIASES(name, error, arguments)                           \
  STEPWIRE_ALIAS("_ZGVbN2" arguments, name, error, "d2_" error "sse2")     \
  STEPWIRE_ALIAS_OF_4("_ZGVcN4" arguments, name, error, "d4_" error "avx") \
  STEPWIRE_ALIAS_OF_4("_ZGVdN4" arguments, name, error, "d4_" error "avx") \
  STEPWIRE_ALIAS_OF_8("_ZGVeN8" arguments, name, error, "d8_" error "avx512fnofma")
#define STEPWIRE_SLEEF_OF_ONE(name, error) \
  STEPWIRE_ALIASES(name, error, "v")       \
  double name(double x) noexcept __asm__(STEPWIRE_SYMBOL(name, error)) STEPWIRE_ATTRIBUTES;
#define STEPWIRE_SLEEF_OF_TWO(name, error) \
  STEPWIRE_ALIASES(name, error, "vv")      \
  double name(double x, double y) noexcept __asm__(STEPWIRE_SYMBOL(name, error)) STEPWIRE_ATTRIBUTES;

namespace sleef {

STEPWIRE_FUNCTIONS(STEPWIRE_SLEEF_OF_ONE, STEPWIRE_SLEEF_OF_TWO)

namespace any_power {
STEPWIRE_SLEEF_OF_TWO(pow, "u10")
}

/// Returns the power x^y. A square is x * x, which is correctly rounded. Lanes choose by bits, since GCC does
/// not vectorise a loop with a branch around a call.
inline double pow(double x, double y) {
#ifdef STEPWIRE_LANES
  const std::uint64_t square = y == 2.0 ? ~std::uint64_t{0} : 0;
  const auto of_square = std::bit_cast<std::uint64_t>(x * x),
             power = std::bit_cast<std::uint64_t>(any_power::pow(x, y));
  return std::bit_cast<double>((of_square & square) | (power & ~square));
#else
  return y == 2.0 ? x * x : any_power::pow(x, y);
#endif
}

}  // namespace sleef

#endif

#ifdef STEPWIRE_LIBM
#define STEPWIRE_CHOICE(of_libm, of_sleef) of_libm
#elif defined(STEPWIRE_SLEEF)
#define STEPWIRE_CHOICE(of_libm, of_sleef) of_sleef
#else
#define STEPWIRE_CHOICE(of_libm, of_sleef) (is_libm ? (of_libm) : (of_sleef))

/// True while this thread calls functions of the C library. Only Selection sets it.
extern constinit thread_local bool is_libm __attribute__((tls_model("initial-exec")));

/// Selects the functions of the C library for this thread, or those of SLEEF, up to the end of its scope.
class Selection {
 public:
  explicit Selection(bool libm) : before_(is_libm) { is_libm = libm; }
  ~Selection() { is_libm = before_; }
  Selection(const Selection&) = delete;
  Selection& operator=(const Selection&) = delete;

 private:
  const bool before_;
};

#endif

#define STEPWIRE_OF_ONE(name, error)                      \
  inline double name(double x) {                          \
    return STEPWIRE_CHOICE(std::name(x), sleef::name(x)); \
  }
#define STEPWIRE_OF_TWO(name, error)                            \
  inline double name(double x, double y) {                      \
    return STEPWIRE_CHOICE(std::name(x, y), sleef::name(x, y)); \
  }

STEPWIRE_FUNCTIONS(STEPWIRE_OF_ONE, STEPWIRE_OF_TWO)

/// Returns the length of a vector, within 1.5 ulp.
inline double hypot(double x, double y, double z) {
  return STEPWIRE_CHOICE(std::hypot(x, y, z), sleef::hypot(sleef::hypot(x, y), z));
}

/// Returns the power x^y.
inline double pow(double x, double y) {
  return STEPWIRE_CHOICE(std::pow(x, y), sleef::pow(x, y));
}

}  // namespace fn

}  // namespace stepwire

#undef STEPWIRE_OF_ONE
#undef STEPWIRE_OF_TWO
