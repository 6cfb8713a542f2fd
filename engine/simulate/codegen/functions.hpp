#pragma once

#include <string>
#include <vector>

#include "engine/simulate/codegen/runs.hpp"

namespace stepwire::codegen {

/// Generates functions from pieces of code. Long ones are split, since the compile time of a function grows
/// faster than its length.
class Functions {
 public:
  /// With `small`, functions are inlined, which pays if the compiler can then keep numbers in registers.
  explicit Functions(bool small) : small_(small) {}

  /// Adds a function with these parameters, which calls `code` at its due ticks.
  void add(const std::string& name, const std::string& parameters, const std::string& arguments,
           const std::vector<Code>& code);
  void add_text(const std::string& text) { text_ += text; }
  const std::string& text() const { return text_; }
  /// Returns the attribute of a function that may be inlined.
  std::string attribute() const;

 private:
  bool small_;
  std::string text_;
};

}  // namespace stepwire::codegen
