#include "engine/base/expression/operation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "engine/base/expression/language.hpp"
#include "engine/base/math/elementary.hpp"

namespace stepwire::expression {
namespace {

constexpr int any_number = std::numeric_limits<int>::max();

struct Power {
  double operator()(double a, double b) const { return fn::pow(a, b); }
};

template <class Of>
constexpr Operation between(std::string_view sign, Binding binding) {
  return {sign, binding, 2, 2, [](const double* v, int) -> double { return Of()(v[0], v[1]); }};
}

template <double (*f)(double)>
constexpr Operation one(std::string_view name) {
  return {name, Binding::atom, 1, 1, [](const double* v, int) { return f(v[0]); }};
}

template <double (*f)(double, double)>
constexpr Operation two(std::string_view name) {
  return {name, Binding::atom, 2, 2, [](const double* v, int) { return f(v[0], v[1]); }};
}

constexpr std::array operators{between<std::logical_or<>>("||", Binding::either),
                               between<std::logical_and<>>("&&", Binding::both),
                               between<std::less_equal<>>("<=", Binding::comparison),
                               between<std::greater_equal<>>(">=", Binding::comparison),
                               between<std::equal_to<>>("==", Binding::comparison),
                               between<std::not_equal_to<>>("!=", Binding::comparison),
                               between<std::less<>>("<", Binding::comparison),
                               between<std::greater<>>(">", Binding::comparison),
                               between<std::plus<>>("+", Binding::sum),
                               between<std::minus<>>("-", Binding::sum),
                               between<std::multiplies<>>("*", Binding::product),
                               between<std::divides<>>("/", Binding::product),
                               between<Power>("^", Binding::power)};

double lognormal(const double* v, int) {
  return language::lognormal(v[0], v[1], v[2]);
}

constexpr std::array functions{one<fn::sin>("sin"),
                               one<fn::cos>("cos"),
                               one<fn::tan>("tan"),
                               one<fn::asin>("asin"),
                               one<fn::acos>("acos"),
                               one<fn::atan>("atan"),
                               one<fn::sinh>("sinh"),
                               one<fn::cosh>("cosh"),
                               one<fn::tanh>("tanh"),
                               one<fn::exp>("exp"),
                               one<fn::log>("log"),
                               one<fn::log2>("log2"),
                               one<fn::log10>("log10"),
                               one<std::sqrt>("sqrt"),
                               one<fn::cbrt>("cbrt"),
                               one<std::fabs>("abs"),
                               one<language::sign>("sign"),
                               one<std::floor>("floor"),
                               one<std::ceil>("ceil"),
                               one<std::round>("round"),
                               two<fn::atan2>("atan2"),
                               two<language::mod>("mod"),
                               two<fn::hypot>("hypot"),
                               two<language::uniform>("uniform"),
                               two<language::normal>("normal"),
                               Operation{"min", Binding::atom, 2, any_number, language::smallest},
                               Operation{"max", Binding::atom, 2, any_number, language::largest},
                               Operation{"lognormal", Binding::atom, 3, 3, lognormal}};

constexpr Operation of_matrices(std::string_view name, int least, int most) {
  return {name, Binding::atom, least, most, nullptr};
}

constexpr std::array matrix_functions{
    of_matrices("transpose", 1, 1), of_matrices("inv", 1, 1),    of_matrices("expm", 1, 1),
    of_matrices("det", 1, 1),       of_matrices("trace", 1, 1),  of_matrices("norm", 1, 1),
    of_matrices("rank", 1, 1),      of_matrices("size", 2, 2),   of_matrices("eye", 1, 1),
    of_matrices("zeros", 1, 2),     of_matrices("ones", 1, 2),   of_matrices("diag", 1, any_number),
    of_matrices("ctrb", 2, 2),      of_matrices("obsv", 2, 2),   of_matrices("c2d", 2, 3),
    of_matrices("care", 4, 4),      of_matrices("dare", 4, 4),   of_matrices("lqr", 4, 4),
    of_matrices("dlqr", 4, 4),      of_matrices("kalman", 4, 4), of_matrices("dkalman", 4, 4),
    of_matrices("place", 3, 3)};

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

bool any_undefined(const double* v, int count) {
  return std::any_of(v, v + count, [](double value) { return std::isnan(value); });
}

template <double (*f)(const double*, int)>
double of_defined(const double* v, int count) {
  return any_undefined(v, count) ? undefined : f(v, count);
}

template <class Of>
constexpr Operation of_defined_pair(std::string_view sign) {
  return {sign, Binding::comparison, 2, 2, [](const double* v, int count) -> double {
            return any_undefined(v, count) ? undefined : Of()(v[0], v[1]);
          }};
}

/// And (decided by 0) or or (decided by any other number).
template <bool decided>
double logic(const double* v, int count) {
  for (int i = 0; i < count; ++i)
    if (!std::isnan(v[i]) && (v[i] != 0.0) == decided) return decided;
  return any_undefined(v, count) ? undefined : !decided;
}

constexpr std::array strict_operations{
    Operation{"||", Binding::either, 2, 2, logic<true>},
    Operation{"&&", Binding::both, 2, 2, logic<false>},
    of_defined_pair<std::less_equal<>>("<="),
    of_defined_pair<std::greater_equal<>>(">="),
    of_defined_pair<std::equal_to<>>("=="),
    of_defined_pair<std::not_equal_to<>>("!="),
    of_defined_pair<std::less<>>("<"),
    of_defined_pair<std::greater<>>(">"),
    Operation{"!", Binding::prefix, 1, 1,
              [](const double* v, int) -> double { return std::isnan(v[0]) ? undefined : v[0] == 0.0; }},
    Operation{"sign", Binding::atom, 1, 1,
              [](const double* v, int) { return std::isnan(v[0]) ? undefined : language::sign(v[0]); }},
    Operation{"min", Binding::atom, 2, any_number, of_defined<language::smallest>},
    Operation{"max", Binding::atom, 2, any_number, of_defined<language::largest>}};

template <class Operations>
const Operation* find(const Operations& among, std::string_view name) {
  const auto found = std::ranges::find(among, name, &Operation::name);
  return found == among.end() ? nullptr : &*found;
}

}  // namespace

constexpr Operation minus{"-", Binding::prefix, 1, 1, [](const double* v, int) { return -v[0]; }};
constexpr Operation negation{"!", Binding::prefix, 1, 1,
                             [](const double* v, int) -> double { return v[0] == 0.0; }};

const Operation* find_operator(std::string_view sign) {
  return find(operators, sign);
}

const Operation* find_function(std::string_view name) {
  return find(functions, name);
}

std::vector<std::string> function_names() {
  std::vector<std::string> names;
  for (const Operation& function : functions) names.emplace_back(function.name);
  return names;
}

const Operation* strict(const Operation* operation) {
  const Operation* found = operation ? find(strict_operations, operation->name) : nullptr;
  return found ? found : operation;
}

const Operation* find_matrix_function(std::string_view name) {
  return find(matrix_functions, name);
}

constexpr Operation brackets{"[]", Binding::atom, 1, any_number, nullptr};

}  // namespace stepwire::expression
