#pragma once

#include <map>
#include <memory>
#include <string>

#include "engine/base/table/table_file.hpp"
#include "engine/model/block/registry.hpp"
#include "engine/simulate/run/executor.hpp"

namespace stepwire::replay {

/// The runs of a sweep as its folder describes them: diagrams, and what each run sets in which of them.
class SweepRuns {
 public:
  /// Throws Error where the table of the sweep is missing or does not have `runs` rows.
  SweepRuns(std::string folder, std::size_t runs, const Registry& registry);
  ~SweepRuns();

  /// The simulation of a run, at time 0. Throws Error where the diagram does not take what it sets.
  run::Executor& begin(std::size_t run);

 private:
  struct Diagram;

  Diagram& diagram_of(std::size_t run);
  const std::string& text(std::size_t column, std::size_t run) const;

  std::string folder_;
  const Registry& registry_;
  table::Table table_;
  table::ColumnWords words_;
  std::map<std::string, std::unique_ptr<Diagram>> diagrams_;  ///< by their names in the folder
};

}  // namespace stepwire::replay
