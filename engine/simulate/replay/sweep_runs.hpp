#pragma once

#include <map>
#include <memory>
#include <string>

#include "engine/base/table/table_file.hpp"
#include "engine/model/block/registry.hpp"
#include "engine/simulate/run/executor.hpp"

namespace stepwire::replay {

/// Runs of a sweep in its folder: the diagrams, and the values that each run sets in one of them.
class SweepRuns {
 public:
  /// Throws Error if the table of the sweep is missing or does not have `runs` rows.
  SweepRuns(std::string folder, std::size_t runs, const Registry& registry);
  ~SweepRuns();

  /// Returns the simulation of a run, at time 0. Throws Error if the diagram refuses the values.
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
