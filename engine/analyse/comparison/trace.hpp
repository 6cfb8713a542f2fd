#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "engine/base/table/table.hpp"

namespace stepwire::comparison {

/// Signal of one run: values at ascending times. Two rows at one time are the sides of an instant.
struct Trace {
  std::vector<double> time;    ///< [s]
  std::vector<double> values;  ///< In SI; without a known unit as recorded.
};

/// Tables of a recording, each with a column `time`. Runs follow each other where the time goes back, or have
/// names such as "run-2/time". A column of a single row is a constant of its run.
class TraceIndex {
 public:
  /// The tables must outlive the index. Columns that are no traces are added to `faults` as sentences.
  TraceIndex(std::span<const table::Table* const> tables, std::vector<std::string>& faults);

  /// Returns the names in the order of the tables, without `time`.
  const std::vector<std::string>& names() const { return names_; }
  bool has(const std::string& name) const { return signals_.contains(name); }
  std::size_t runs(const std::string& name) const { return signals_.at(name).pieces.size(); }
  const std::string& unit(const std::string& name) const { return signals_.at(name).unit; }
  /// Returns the trace of one run.
  Trace trace(const std::string& name, std::size_t run) const;

 private:
  struct Piece {
    const table::Column *time, *values;
    std::size_t begin, end;
  };
  struct Signal {
    std::string unit;
    std::vector<Piece> pieces;
  };

  void add_table(const table::Table& table, std::vector<std::string>& faults);
  void add(const std::string& name, const table::Column& time, const table::Column& values,
           std::vector<std::string>& faults);

  std::vector<std::string> names_;
  std::map<std::string, Signal> signals_;
};

}  // namespace stepwire::comparison
