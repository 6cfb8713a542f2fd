#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/query/symbol_table.hpp"
#include "engine/model/plan/plan.hpp"

namespace stepwire::live {

/// Scalar of a diagram that changes in time.
struct LiveSignal {
  std::string name;  ///< "cart.position", "path.2" of a vector, as in signals.csv
  std::optional<unit::Dimension> dimension;
  std::size_t offset = 0;  ///< in the workspace of a run
  bool recorded = false;   ///< true if the file records it
};

/// Scalar signals of a diagram, including the elements of vectors: recorded ones first, in the order of the
/// file, then the others by name. Several names may refer to one number.
class SignalList {
 public:
  explicit SignalList(const plan::Plan& plan);

  const std::vector<LiveSignal>& all() const { return signals_; }
  /// Returns the index of a signal, or std::nullopt.
  std::optional<std::size_t> find(const std::string& name) const;
  /// Returns the names that expressions may use: all signals and numeric parameters. The file is for
  /// messages.
  query::SymbolTable names(const plan::Plan& plan) const;

 private:
  void add(const plan::Plan& plan, const std::string& name, const diagram::SignalRef& signal, bool recorded);

  std::vector<LiveSignal> signals_;
  std::map<std::string, std::size_t> index_;
};

/// Returns the SI unit of a signal as text; "" if it has none or it is unknown.
std::string unit_text(const std::optional<unit::Dimension>& dimension);

}  // namespace stepwire::live
