#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace stepwire {

/// One measured number. A table shows results of one workload and unit side by side.
struct Result {
  std::string workload;  ///< Name of the workload: "W2 1000".
  std::string by;        ///< Method: "interpreted", "by hand".
  std::string unit;      ///< Unit: "ns per step".
  double value = 0.0;
  std::size_t blocks = 0;  ///< Number of blocks of the workload.
};

/// Writes results as JSON, one per line. Returns false if the file cannot be written.
bool write_json_lines(const std::vector<Result>& results, const std::string& path);

}  // namespace stepwire
