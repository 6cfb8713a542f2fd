#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/session/loaded_model.hpp"
#include "engine/base/table/run_view.hpp"
#include "engine/simulate/record/recording.hpp"

namespace stepwire::session {

/// Formats of signal files, named as in the option --files.
enum class FileKind { csv, mat, h5, mcap };
using FileKinds = std::vector<FileKind>;

/// Formats of a call without --files.
inline const FileKinds usual_files{FileKind::csv, FileKind::mat};

/// Largest count of numbers of a recording that are written as CSV, about 1 GB.
inline constexpr double most_numbers_of_csv = 50e6;

/// Returns the formats that a call names. Without any: the usual ones, or h5 alone if a recording may exceed
/// the CSV limit. Throws Error if csv is named and the recording exceeds the limit.
FileKinds files_for(const LoadedModel& model, const std::optional<FileKinds>& named);

/// Parses a format by its file extension; std::nullopt if unknown.
std::optional<FileKind> file_kind(const std::string& name);
/// Returns "csv, mat, h5, mcap".
std::string file_kind_names();

/// Returns "signals.csv", and so on for each format.
std::vector<std::string> signal_file_names(const FileKinds& kinds);

/// Returns the text of signals.csv for a recording.
std::string signals_csv(const record::Recording& recording);

/// File with one group per run; runs are added in order.
class RunFile {
 public:
  virtual ~RunFile() = default;
  virtual void add(const table::RunView& run) = 0;
  /// Completes the file and gives it its final name.
  virtual void finish() = 0;
};

/// True if files of this format have one group per run; the others have one table of all runs.
bool has_runs(FileKind kind);
/// Returns "DIR/signals.h5", or "DIR/signals-2.h5" for the second recording.
std::string signals_path(const std::string& folder, FileKind kind, std::size_t recording);
/// Opens a file of runs. This function and the methods of the file throw EnvironmentError.
std::unique_ptr<RunFile> open_run_file(const std::string& path, FileKind kind, const std::string& title);

/// Returns a note on omitted CSV files and their replacement, "signals.csv would have 6e+07 numbers ...";
/// empty if none is omitted.
std::string csv_left_out(const std::vector<record::Recording>& recordings, const FileKinds& kinds);

/// Writes the recordings into a folder in each format: signals.csv, then signals-2.csv, ... for further
/// periods. HDF5 replaces a CSV file that would be too large. Each file is written completely or not at all.
/// Throws EnvironmentError.
void write_signals(const std::string& folder, const LoadedModel& model,
                   const std::vector<record::Recording>& recordings, const FileKinds& kinds);

}  // namespace stepwire::session
