#pragma once

#include <memory>
#include <span>
#include <string>

#include "engine/base/table/run_view.hpp"

namespace stepwire::hdf5 {

/// Writes runs into an HDF5 file. The file appears under its name complete or not at all. A run's columns are
/// datasets of doubles with their unit as attribute `units`. A named run is a group with its swept values as
/// scalars. Longer datasets have chunks of 8192 rows. Datasets are listed in the order of writing. No times
/// are stored, so the same runs give the same bytes. Methods throw EnvironmentError where the system refuses.
class Hdf5Writer {
 public:
  /// `title` is an attribute of the file.
  Hdf5Writer(const std::string& path, const std::string& title);
  ~Hdf5Writer();
  Hdf5Writer(const Hdf5Writer&) = delete;
  Hdf5Writer& operator=(const Hdf5Writer&) = delete;

  void add(const table::RunView& run);
  /// Begins a run whose rows are appended later; the view has its first rows. Its datasets are chunked.
  void begin(const table::RunView& run);
  /// Appends rows to the run begun last: equally long pieces of all series, in their order.
  void append(std::span<const std::span<const double>> columns);
  /// Writes all buffers, so that other programs can read the rows even if this process ends abruptly.
  void flush();
  /// Flushes and renames the file to its final name; more rows may follow.
  void publish();
  /// Closes the file and renames it to its final name.
  void finish();

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace stepwire::hdf5
