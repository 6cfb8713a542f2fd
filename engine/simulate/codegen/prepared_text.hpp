#pragma once

#include <functional>
#include <string>

#include "engine/simulate/codegen/literals.hpp"
#include "engine/simulate/codegen/tuning.hpp"

namespace stepwire::codegen {

/// Writes calls of prepare() as C++. A block is set up from parameters and prepares its members one element
/// at a time, so that none of them allocates memory.
class PreparedText {
 public:
  /// Function element(i, k) that returns number k of the value of the i-th binding of the tuning.
  using Element = std::function<std::string(std::size_t i, std::size_t k)>;

  PreparedText(const plan::Plan& plan, const Tuning& tuning, Element element)
      : plan_(plan), tuning_(tuning), element_(std::move(element)) {}

  std::string call(const PreparedBlock& block);
  /// Returns the definitions of lists that the calls read.
  std::string tables() const;

 private:
  std::string set_up(std::size_t block, std::size_t k);
  std::string member_text(std::size_t block, std::size_t member, std::size_t k);
  std::string from_binding(std::size_t block, const ParameterSpec& spec, std::size_t binding,
                           std::size_t k) const;

  const plan::Plan& plan_;
  const Tuning& tuning_;
  Element element_;
  Literals literals_;
};

}  // namespace stepwire::codegen
