#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace stepwire {

/// One number that was measured. A table puts results of one workload and unit side by side.
struct Result {
  std::string workload;  ///< "W2 1000"
  std::string by;        ///< who did the work: "interpreted", "by hand"
  std::string unit;      ///< "ns per step"
  double value = 0.0;
  std::size_t blocks = 0;  ///< of the workload
};

/// Writes results as JSON, one to a line. False if the file cannot be written.
bool write_json_lines(const std::vector<Result>& results, const std::string& path);

}  // namespace stepwire
