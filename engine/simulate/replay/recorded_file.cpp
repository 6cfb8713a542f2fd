#include "engine/simulate/replay/recorded_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "engine/base/hdf5/hdf5_read.hpp"

namespace stepwire::replay {

namespace {

std::string path_of(const std::string& folder, std::size_t recording, const char* ending) {
  return (std::filesystem::path(folder) / io::numbered("signals", recording, ending)).string();
}

bool is_there(const std::string& path) {
  std::error_code none;
  return std::filesystem::exists(path, none);
}

}  // namespace

std::string recorded_file(const std::string& folder, std::size_t recording) {
  const std::string csv = path_of(folder, recording, ".csv"), h5 = path_of(folder, recording, ".h5");
  if (is_there(csv)) return csv;
  if (is_there(h5)) return h5;
  throw yaml::Error(yaml::Fault{
      {csv, {}},
      "",
      fmt::format("is missing; verify needs it or {}, which 'run --out' writes of a diagram that records something, with csv or "
                  "h5 among '--files'",
                  std::filesystem::path(h5).filename().string()),
      {}});
}

bool has_lines(const std::string& file) {
  return file.ends_with(".csv");
}

Recorded read_recorded(const std::string& file, std::size_t first_signal, table::ColumnWords& words) {
  if (has_lines(file)) return {file, table::read_csv(file, words), first_signal};
  table::RecordTable table = hdf5::read_hdf5(file);
  words = std::move(table.words);
  Recorded recorded{file, std::move(table), first_signal, false};
  require_equal_lengths(recorded);
  return recorded;
}

void require_equal_lengths(const Recorded& recorded) {
  for (const table::Column& column : recorded.table.columns)
    if (column.values.size() != recorded.table.rows())
      throw table::TableError(fmt::format("{}: {} has {} rows, and {} has {}", recorded.file, column.name,
                                          column.values.size(), recorded.table.columns.front().name,
                                          recorded.table.rows()));
}

}  // namespace stepwire::replay
