#include "engine/base/expression/cpp_piece.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace stepwire::expression {
namespace {

/// Functions of language.hpp that formulas can call; all others are in <cmath>.
constexpr std::array<std::string_view, 6> own_functions{"sign", "mod", "min", "max", "uniform", "lognormal"};

/// Returns the text, parenthesised where it binds weaker than `least`.
std::string in(Binding least, const CppPiece& piece) {
  return piece.binding < least ? "(" + piece.text + ")" : piece.text;
}

CppPiece number(const CppPiece& piece) {
  return piece.truth ? CppPiece{"language::number(" + piece.text + ")"} : piece;
}

/// Parenthesises && inside of ||, since compilers warn about it.
CppPiece logic(std::string_view sign, Binding binding, const CppPiece& a, const CppPiece& b) {
  const std::string left = in(a.binding == binding ? binding : Binding::comparison, cpp_truth(a));
  return {fmt::format("{} {} {}", left, sign, in(Binding::comparison, cpp_truth(b))), binding, true};
}

CppPiece comparison(std::string_view sign, const CppPiece& a, const CppPiece& b) {
  return {fmt::format("{} {} {}", in(Binding::sum, number(a)), sign, in(Binding::sum, number(b))),
          Binding::comparison, true};
}

CppPiece arithmetic(std::string_view sign, Binding binding, const CppPiece& a, const CppPiece& b) {
  const auto stronger = static_cast<Binding>(static_cast<int>(binding) + 1);
  return {fmt::format("{} {} {}", in(binding, number(a)), sign, in(stronger, number(b))), binding};
}

/// Parenthesises a repeated minus, since "--" is another operator.
CppPiece prefix(std::string_view sign, const CppPiece& a) {
  if (sign == "!" && a.truth) return {"!" + in(Binding::prefix, a), Binding::prefix, true};
  if (sign == "!") return {in(Binding::sum, a) + " == 0.0", Binding::comparison, true};
  return {"-" + in(Binding::atom, number(a)), Binding::prefix};
}

CppPiece call(std::string_view function, const std::vector<CppPiece>& values) {
  std::string list;
  for (const CppPiece& value : values) list += (list.empty() ? "" : ", ") + number(value).text;
  if (function == "min" || function == "max") list = "{" + list + "}";
  const bool own = std::find(own_functions.begin(), own_functions.end(), function) != own_functions.end();
  return {fmt::format("{}::{}({})", own ? "language" : "std", function, list)};
}

CppPiece choice(const CppPiece& condition, const CppPiece& a, const CppPiece& b) {
  return {fmt::format("{} ? {} : {}", in(Binding::either, condition), in(Binding::either, a), b.text),
          Binding::condition, a.truth};
}

}  // namespace

CppPiece cpp_number(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return {std::move(text), std::signbit(value) ? Binding::prefix : Binding::atom};
}

CppPiece cpp_truth(const CppPiece& piece) {
  if (piece.truth) return piece;
  return {in(Binding::sum, piece) + " != 0.0", Binding::comparison, true};
}

CppPiece cpp_operation(const Operation& operation, const std::vector<CppPiece>& values) {
  const Binding binding = operation.binding;
  const std::string_view name = operation.name;
  if (binding == Binding::atom) return call(name, values);
  if (binding == Binding::power) return call("pow", values);
  if (binding == Binding::prefix) return prefix(name, values[0]);
  if (binding == Binding::comparison) return comparison(name, values[0], values[1]);
  return binding < Binding::comparison ? logic(name, binding, values[0], values[1])
                                       : arithmetic(name, binding, values[0], values[1]);
}

CppPiece cpp_choice(const CppPiece& condition, const CppPiece& a, const CppPiece& b) {
  if (!a.truth || !b.truth) return choice(cpp_truth(condition), number(a), number(b));
  return choice(cpp_truth(condition), a, b);
}

}  // namespace stepwire::expression
