#pragma once

#include <map>

#include "engine/simulate/codegen/names.hpp"
#include "engine/simulate/codegen/runs.hpp"

namespace stepwire::codegen {

/// The numbers of the workspace before the first tick, as statements.
class StartText {
 public:
  /// `places` are of numbers that vary: the place of the workspace, and that in the table they are read from.
  StartText(const plan::Plan& plan, const PlaceNames& names, const std::map<std::size_t, std::size_t>& places)
      : plan_(plan), names_(names), places_(places) {}

  /// Of the constants of wires.
  std::string constants() const;
  /// Of all blocks; what is not named is 0 before.
  std::vector<Code> initial() const;

 private:
  std::string number_at(std::size_t place, double number) const;
  void add_initial(std::size_t block, std::vector<Code>& code) const;

  const plan::Plan& plan_;
  const PlaceNames& names_;
  const std::map<std::size_t, std::size_t>& places_;
};

}  // namespace stepwire::codegen
