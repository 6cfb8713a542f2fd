#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/json/json.hpp"

namespace stepwire::live {

/// Arguments of a call. Each function throws std::runtime_error if the argument is missing or has the wrong
/// type.
class Arguments {
 public:
  explicit Arguments(const json::Json& of) : of_(of) {}

  double number(const char* key) const;
  std::string text(const char* key) const;
  bool flag(const char* key) const;
  /// Returns `otherwise` if the key is missing.
  bool flag_or(const char* key, bool otherwise) const;
  std::vector<double> numbers(const char* key) const;
  /// Returns whole numbers, 0 or greater.
  std::vector<std::size_t> indices(const char* key) const;
  const json::Json& list(const char* key) const;
  /// Returns std::nullopt if the value is a text.
  std::optional<double> number_if_no_text(const char* key) const;
  /// Returns std::nullopt if the key is missing or null.
  std::optional<double> number_if_any(const char* key) const;

 private:
  const json::Json& of_;
};

}  // namespace stepwire::live
