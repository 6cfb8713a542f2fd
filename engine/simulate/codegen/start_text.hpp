#pragma once

#include <map>

#include "engine/simulate/codegen/names.hpp"
#include "engine/simulate/codegen/runs.hpp"

namespace stepwire::codegen {

/// Statements that set the numbers of the workspace before the first tick.
class StartText {
 public:
  /// `places` maps places of variable numbers in the workspace to places in the table that they are read
  /// from.
  StartText(const plan::Plan& plan, const PlaceNames& names, const std::map<std::size_t, std::size_t>& places)
      : plan_(plan), names_(names), places_(places) {}

  /// Returns the statements for constants on wires.
  std::string constants() const;
  /// Returns the statements for all blocks; all other numbers must be 0 before.
  std::vector<Code> initial() const;

 private:
  std::string number_at(std::size_t place, double number) const;
  void add_initial(std::size_t block, std::vector<Code>& code) const;

  const plan::Plan& plan_;
  const PlaceNames& names_;
  const std::map<std::size_t, std::size_t>& places_;
};

}  // namespace stepwire::codegen
