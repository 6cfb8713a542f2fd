#pragma once

#include <memory>
#include <span>
#include <string>

#include "engine/base/table/run_view.hpp"

namespace stepwire::hdf5 {

/// Writes runs into an HDF5 file, which appears whole under its name or not at all. A run's columns are
/// datasets of doubles with their unit as attribute `units`; a named run is a group with its swept values as
/// scalars. Longer ones are chunked by 8192 rows. Datasets are listed in the order in which they were
/// written, and the same runs give the same bytes: no times. Methods throw EnvironmentError where the system
/// refuses.
class Hdf5Writer {
 public:
  /// `title` is an attribute of the file.
  Hdf5Writer(const std::string& path, const std::string& title);
  ~Hdf5Writer();
  Hdf5Writer(const Hdf5Writer&) = delete;
  Hdf5Writer& operator=(const Hdf5Writer&) = delete;

  void add(const table::RunView& run);
  /// Adds a run whose rows come later: those of the view are its first ones. Its datasets are chunked.
  void begin(const table::RunView& run);
  /// Appends rows to the run that was begun last: a piece of each series in their order, of equal length.
  void append(std::span<const std::span<const double>> columns);
  /// What was written can be read by other programs, also where this one ends without a further call.
  void flush();
  /// The same, and the file has its name from now on, although more may follow.
  void publish();
  /// Closes the file and gives it its name.
  void finish();

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace stepwire::hdf5
