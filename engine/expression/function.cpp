#include "engine/expression/function.hpp"

#include <muParser.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "engine/expression/language.hpp"

namespace stepwire {
namespace {

using One = double (*)(double);
using Two = double (*)(double, double);

constexpr int any_number = std::numeric_limits<int>::max();

constexpr std::array<std::pair<std::string_view, Arity>, 27> functions{{
    {"sin", {}},
    {"cos", {}},
    {"tan", {}},
    {"asin", {}},
    {"acos", {}},
    {"atan", {}},
    {"sinh", {}},
    {"cosh", {}},
    {"tanh", {}},
    {"exp", {}},
    {"log", {}},
    {"log2", {}},
    {"log10", {}},
    {"sqrt", {}},
    {"cbrt", {}},
    {"abs", {}},
    {"sign", {}},
    {"floor", {}},
    {"ceil", {}},
    {"round", {}},
    {"atan2", {2, 2}},
    {"mod", {2, 2}},
    {"hypot", {2, 2}},
    {"min", {2, any_number}},
    {"max", {2, any_number}},
    {"uniform", {2, 2}},
    {"lognormal", {3, 3}},
}};

double negative(double x) {
  return -x;
}
double is_zero(double x) {
  return x == 0.0 ? 1.0 : 0.0;
}
double is_not_zero(double x) {
  return x == 0.0 ? 0.0 : 1.0;
}
double minus_is_zero(double x) {
  return -is_zero(x);
}
double minus_is_not_zero(double x) {
  return -is_not_zero(x);
}

/// The signs before a value that a run of '-' and '!' comes down to.
void define_prefixes(mu::Parser& parser) {
  constexpr std::pair<const char*, One> prefixes[] = {
      {"-", negative}, {"!", is_zero}, {"~", is_not_zero}, {"#", minus_is_zero}, {"$", minus_is_not_zero}};
  for (const auto& [name, function] : prefixes) parser.DefineInfixOprt(name, function, mu::prINFIX, false);
}

constexpr std::pair<const char*, One> ones[] = {
    {"sin", std::sin},        {"cos", std::cos},     {"tan", std::tan},   {"asin", std::asin},
    {"acos", std::acos},      {"atan", std::atan},   {"sinh", std::sinh}, {"cosh", std::cosh},
    {"tanh", std::tanh},      {"exp", std::exp},     {"log", std::log},   {"log2", std::log2},
    {"log10", std::log10},    {"sqrt", std::sqrt},   {"cbrt", std::cbrt}, {"abs", std::fabs},
    {"sign", language::sign}, {"floor", std::floor}, {"ceil", std::ceil}, {"round", std::round}};
constexpr std::pair<const char*, Two> twos[] = {
    {"atan2", std::atan2}, {"hypot", std::hypot}, {"mod", language::mod}, {"uniform", language::uniform}};

void define_functions(mu::Parser& parser) {
  for (const auto& [name, function] : ones) parser.DefineFun(name, function, false);
  for (const auto& [name, function] : twos) parser.DefineFun(name, function, false);
  parser.DefineFun("min", language::smallest, false);
  parser.DefineFun("max", language::largest, false);
  parser.DefineFun("lognormal", language::lognormal, false);
}

}  // namespace

const Arity* find_function(std::string_view name) {
  for (const auto& [known, arity] : functions) {
    if (known == name) return &arity;
  }
  return nullptr;
}

double call_function(std::string_view name, std::span<const double> values) {
  for (const auto& [known, function] : ones) {
    if (known == name) return function(values[0]);
  }
  for (const auto& [known, function] : twos) {
    if (known == name) return function(values[0], values[1]);
  }
  if (name == "lognormal") return language::lognormal(values[0], values[1], values[2]);
  const int count = static_cast<int>(values.size());
  return name == "min" ? language::smallest(values.data(), count) : language::largest(values.data(), count);
}

void define_language(mu::Parser& parser) {
  parser.ClearFun();
  parser.ClearConst();
  parser.ClearInfixOprt();
  parser.ClearPostfixOprt();
  // The optimizer regroups sums and products, which changes last bits and what inf and nan give.
  parser.EnableOptimizer(false);
  define_prefixes(parser);
  define_functions(parser);
}

}  // namespace stepwire
