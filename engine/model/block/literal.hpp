#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

#include "engine/base/math/function.hpp"
#include "engine/model/block/rational.hpp"
#include "engine/model/signal/per_element.hpp"

namespace stepwire {

namespace detail {

/// Returns the C++ name of a type, "stepwire::Gain".
template <class Type>
std::string type_name() {
  constexpr std::string_view text = __PRETTY_FUNCTION__;
  constexpr std::size_t start = text.find("Type = ") + 7, end = text.find_first_of(";]", start);
  return std::string(text.substr(start, end - start));
}

}  // namespace detail

/// Writer of a block's numbers in C++: as literals, or as references to a table of the program.
class LiteralWriter {
 public:
  virtual ~LiteralWriter() = default;
  virtual std::string number(double value) = 0;
  virtual std::string flag(bool value) = 0;
  virtual std::string enumerator(int value, const std::string& type) = 0;
  /// Returns a C++ pointer to these contiguous numbers.
  virtual std::string numbers(const double* values, Index size) = 0;
  /// Returns a whole number, such as a seed or a count.
  virtual std::string whole(std::int64_t value) = 0;
  virtual std::string natural(std::uint64_t value) = 0;
  /// Returns a function whose value is this C++ expression over v, a double or a bool; 0 for an empty one.
  virtual std::string function(const std::string& expression);
};

/// Writer of a member of type T as a C++ expression that can be assigned to it. Types of a block have a
/// specialisation beside its declaration.
template <class T>
struct Literal;

template <>
struct Literal<double> {
  static std::string text(double value, LiteralWriter& writer) { return writer.number(value); }
};

template <>
struct Literal<bool> {
  static std::string text(bool value, LiteralWriter& writer) { return writer.flag(value); }
};

template <std::signed_integral T>
struct Literal<T> {
  static std::string text(T value, LiteralWriter& writer) { return writer.whole(value); }
};

template <std::unsigned_integral T>
struct Literal<T> {
  static std::string text(T value, LiteralWriter& writer) { return writer.natural(value); }
};

template <class T>
requires std::is_enum_v<T>
struct Literal<T> {
  static std::string text(T value, LiteralWriter& writer) {
    return writer.enumerator(static_cast<int>(value), detail::type_name<T>());
  }
};

template <>
struct Literal<Numbers> {
  static std::string text(const Numbers& value, LiteralWriter& writer);
};
template <>
struct Literal<PerElement> {
  static std::string text(const PerElement& value, LiteralWriter& writer);
};
template <>
struct Literal<Matrix> {
  static std::string text(const Matrix& value, LiteralWriter& writer);
};
template <>
struct Literal<Function> {
  static std::string text(const Function& value, LiteralWriter& writer);
};
template <class T, std::size_t size>
struct Literal<std::array<T, size>> {
  static std::string text(const std::array<T, size>& value, LiteralWriter& writer) {
    std::string list;
    for (const T& element : value) list += (list.empty() ? "{" : ", ") + Literal<T>::text(element, writer);
    return list + "}";
  }
};
template <>
struct Literal<Rational> {
  static std::string text(const Rational& value, LiteralWriter& writer);
};

template <class T>
concept has_literal = requires(const T& value, LiteralWriter& writer) {
  Literal<T>::text(value, writer);
};

}  // namespace stepwire
