#include "engine/base/data_file/data_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "engine/base/hdf5/hdf5_read.hpp"
#include "engine/base/mat/mat_file.hpp"
#include "engine/base/mcap/mcap_read.hpp"
#include "engine/base/table/table_file.hpp"

namespace stepwire::data_file {

namespace {

using Read = table::RecordTable (*)(const std::string& path);

/// By the ending of the file, in lower case.
const std::map<std::string, Read>& readers() {
  static const std::map<std::string, Read> all{
      {".csv", table::read_record_csv},
      {".mat", [](const std::string& path) { return table::RecordTable{mat::read_mat(path)}; }},
      {".h5", hdf5::read_hdf5},
      {".hdf5", hdf5::read_hdf5},
      {".mcap", mcap::read_mcap},
  };
  return all;
}

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

}  // namespace

table::RecordTable read_data_file(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  const auto reader = readers().find(lower(ending));
  if (reader == readers().end())
    throw table::TableError(fmt::format("{}: a table is a .csv, .mat, .h5 or .mcap file, not '{}'", path, ending));
  return reader->second(path);
}

bool has_lines(const std::string& path) {
  return lower(std::filesystem::path(path).extension().string()) == ".csv";
}

}  // namespace stepwire::data_file
