#include "engine/base/data_file/data_file.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "engine/base/mat/mat_file.hpp"
#include "engine/base/table/table_file.hpp"

namespace stepwire::data_file {

table::RecordTable read_data_file(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".csv" || ending == ".CSV") return table::read_record_csv(path);
  if (ending == ".mat" || ending == ".MAT") return {mat::read_mat(path)};
  throw table::TableError(fmt::format("{}: a table is a .csv or a .mat file, not '{}'", path, ending));
}

}  // namespace stepwire::data_file
