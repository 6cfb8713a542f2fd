#include "engine/base/data_file/recorded_run.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "engine/base/data_file/data_file.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/table/table_file.hpp"

namespace stepwire::data_file {

namespace {

/// Returns the files signals.h5, signals-2.h5, ... of a folder, of the first kind that it has.
std::vector<std::string> signal_files(const std::string& folder) {
  for (const char* ending : {".h5", ".csv", ".mat"}) {
    std::vector<std::string> files;
    for (std::size_t i = 0;; ++i) {
      const std::string file = folder + "/" + io::numbered("signals", i, ending);
      if (!std::filesystem::exists(file)) break;
      files.push_back(file);
    }
    if (!files.empty()) return files;
  }
  throw table::TableError(fmt::format(
      "{0}: has no signals.h5, signals.csv or signals.mat; 'stepwire run FILE --out {0}' writes them",
      folder));
}

}  // namespace

std::vector<table::RecordTable> read_recorded_run(const std::string& path) {
  const std::vector<std::string> files =
      std::filesystem::is_directory(path) ? signal_files(path) : std::vector{path};
  std::vector<table::RecordTable> tables;
  try {
    for (const std::string& file : files) tables.push_back(read_data_file(file));
  } catch (const io::EnvironmentError& error) {
    throw table::TableError(error.what());
  }
  return tables;
}

}  // namespace stepwire::data_file
