#include "engine/base/data_file/data_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "engine/base/csv/read_record.hpp"
#include "engine/base/hdf5/hdf5_read.hpp"
#include "engine/base/mat/mat_file.hpp"
#include "engine/base/mcap/mcap_read.hpp"
#include "engine/base/table/table_file.hpp"

namespace stepwire::data_file {

namespace {

using Read = table::RecordTable (*)(const std::string& path, Decimal decimal);

/// Adapts a reader of files whose numbers have no decimal mark.
template <auto read>
table::RecordTable read_numbers(const std::string& path, Decimal) {
  return read(path);
}

/// Readers by the extension of the file, in lower case.
const std::map<std::string, Read>& readers() {
  static const std::map<std::string, Read> all{
      {".csv", csv::read_record},
      {".tsv", csv::read_record},
      {".txt", csv::read_record},
      {".dat", csv::read_record},
      {".mat", read_numbers<mat::read_mat>},
      {".h5", read_numbers<hdf5::read_hdf5>},
      {".hdf5", read_numbers<hdf5::read_hdf5>},
      {".mcap", read_numbers<mcap::read_mcap>},
  };
  return all;
}

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

}  // namespace

table::RecordTable read_data_file(const std::string& path, Decimal decimal) {
  const std::string ending = std::filesystem::path(path).extension().string();
  const auto reader = readers().find(lower(ending));
  if (reader == readers().end())
    throw table::TableError(
        fmt::format("{}: a table is a .csv, .tsv, .txt, .dat, .mat, .h5 or .mcap file, not "
                    "'{}'; save a workbook as CSV",
                    path, ending));
  return reader->second(path, decimal);
}

bool has_lines(const std::string& path) {
  const auto reader = readers().find(lower(std::filesystem::path(path).extension().string()));
  return reader != readers().end() && reader->second == Read(csv::read_record);
}

}  // namespace stepwire::data_file
