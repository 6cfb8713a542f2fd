#pragma once

#include <string>

#include "engine/model/signal/per_element.hpp"

namespace stepwire {

/// Access to the numbers of a member of type T that prepare() computes. Types of a block have a
/// specialisation beside its declaration.
template <class T>
struct PreparedParts;

template <>
struct PreparedParts<double> {
  static constexpr bool by_element = false;
  static Index count(double) { return 1; }
  static std::string text(Index) { return ""; }
  static void put(double& member, const double* numbers, Index) { member = *numbers; }
};

/// Prepared element by element, each in a block of one element, which needs no heap memory.
template <>
struct PreparedParts<PerElement> {
  static constexpr bool by_element = true;
  static Index count(const PerElement& member) { return member.size(); }
  static std::string text(Index) { return ".data()[0]"; }
  static void put(PerElement& member, const double* numbers, Index count) {
    member = PerElement(Numbers(numbers, count));
  }
};

template <>
struct PreparedParts<Numbers> {
  static constexpr bool by_element = false;
  static Index count(const Numbers& member) { return member.size() <= Numbers::capacity ? member.size() : 0; }
  static std::string text(Index k) { return "[" + std::to_string(k) + "]"; }
  static void put(Numbers& member, const double* numbers, Index count) { member = Numbers(numbers, count); }
};

}  // namespace stepwire
