#pragma once

#include <string>
#include <vector>

#include "engine/simulate/codegen/runs.hpp"

namespace stepwire::codegen {

/// Writes functions out of pieces of code. A long one is split, since what a compiler needs for a function
/// grows faster than the function.
class Functions {
 public:
  /// `small`: functions may be put into each other, which is worth it where the compiler then keeps numbers
  /// in registers.
  explicit Functions(bool small) : small_(small) {}

  /// Adds a function with these parameters, which calls `code` where it is due.
  void add(const std::string& name, const std::string& parameters, const std::string& arguments,
           const std::vector<Code>& code);
  void add_text(const std::string& text) { text_ += text; }
  const std::string& text() const { return text_; }
  /// What stands before a function that may be put into others.
  std::string attribute() const;

 private:
  bool small_;
  std::string text_;
};

}  // namespace stepwire::codegen
