#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/query/symbol_table.hpp"
#include "engine/model/plan/plan.hpp"

namespace stepwire::live {

/// One number of a diagram that changes in time.
struct LiveSignal {
  std::string name;  ///< "cart.position", "path.2" of a vector, as in signals.csv
  std::optional<unit::Dimension> dimension;
  std::size_t offset = 0;  ///< in the workspace of a run
  bool recorded = false;   ///< by the file
};

/// All signals of a diagram that are numbers or elements of vectors: those of its records first, in their
/// order, then the others by name. Several names may be of one number.
class SignalList {
 public:
  explicit SignalList(const plan::Plan& plan);

  const std::vector<LiveSignal>& all() const { return signals_; }
  /// Where a signal of this name stands.
  std::optional<std::size_t> find(const std::string& name) const;
  /// What expressions may name: all signals and the numbers of parameters. The file is for messages.
  query::SymbolTable names(const plan::Plan& plan) const;

 private:
  void add(const plan::Plan& plan, const std::string& name, const diagram::SignalRef& signal, bool recorded);

  std::vector<LiveSignal> signals_;
  std::map<std::string, std::size_t> index_;
};

/// The SI unit of a signal as text; empty where it has none or none is known.
std::string unit_text(const std::optional<unit::Dimension>& dimension);

}  // namespace stepwire::live
