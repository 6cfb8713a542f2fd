#include "bench/result.hpp"

#include <fstream>

#include "engine/base/json/json.hpp"

namespace stepwire {

bool write_json_lines(const std::vector<Result>& results, const std::string& path) {
  std::ofstream file(path);
  for (const Result& result : results)
    file << json::Json::object()
                .set("workload", result.workload)
                .set("blocks", result.blocks)
                .set("by", result.by)
                .set("unit", result.unit)
                .set("value", result.value)
                .text(-1)
         << '\n';
  file.close();
  return !file.fail();
}

}  // namespace stepwire
