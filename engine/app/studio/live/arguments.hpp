#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/json/json.hpp"

namespace stepwire::live {

/// The arguments of a call. Each throws std::runtime_error where what it names is missing or something else.
class Arguments {
 public:
  explicit Arguments(const json::Json& of) : of_(of) {}

  double number(const char* key) const;
  std::string text(const char* key) const;
  bool flag(const char* key) const;
  /// `otherwise` where the key is missing.
  bool flag_or(const char* key, bool otherwise) const;
  std::vector<double> numbers(const char* key) const;
  /// Whole numbers from 0 on.
  std::vector<std::size_t> indices(const char* key) const;
  const json::Json& list(const char* key) const;
  /// Nothing where the value is a text.
  std::optional<double> number_if_no_text(const char* key) const;
  /// Nothing where the key is missing or null.
  std::optional<double> number_if_any(const char* key) const;

 private:
  const json::Json& of_;
};

}  // namespace stepwire::live
