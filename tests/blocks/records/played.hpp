#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/base/table/table_file.hpp"
#include "tests/support/run_text.hpp"

/// A record with a row every `interval` [s] from 0 on: time, and y in mm of it.
inline std::string record_text(std::size_t rows, double interval, const std::function<double(double)>& y) {
  stepwire::table::Table table{{{"time", "s", {}}, {"y", "mm", {}}}};
  for (std::size_t row = 0; row < rows; ++row) {
    table.columns[0].values.push_back(static_cast<double>(row) * interval);
    table.columns[1].values.push_back(y(table.columns[0].values.back()));
  }
  return stepwire::table::csv_text(table);
}

/// A diagram that plays column y of a file with these keys, at every `step` up to `stop`.
inline std::string player(const std::string& file, const std::string& keys, const std::string& step,
                          const std::string& stop) {
  return "step: " + step + "\nstop: " + stop + "\nblocks:\n  y: {block: FromFile, file: '" + file +
         "', column: y, " + keys + "}\nrecord: [y]\n";
}

inline std::vector<double> played(const std::string& file, const std::string& keys, const std::string& step,
                                  const std::string& stop) {
  return stepwire::column(stepwire::run_text(player(file, keys, step, stop)), "y");
}

/// The message with which such a diagram is refused.
inline std::string refusal(const std::string& file, const std::string& keys) {
  return stepwire::error_of(player(file, keys, "0.1 s", "0.1 s"));
}
