#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/session/loaded_model.hpp"
#include "engine/base/table/run_view.hpp"
#include "engine/simulate/record/recording.hpp"

namespace stepwire::session {

/// Kinds of files that a run leaves its numbers and pictures in, as the option --files names them.
enum class FileKind { csv, mat, h5, mcap };
using FileKinds = std::vector<FileKind>;

/// Those that a call has which names none.
inline const FileKinds usual_files{FileKind::csv, FileKind::mat};

/// Up to so many numbers of a recording are written as CSV, which are about 1 GB.
inline constexpr double most_numbers_of_csv = 50e6;

/// The kinds that a call names; else the usual ones, or h5 alone where a recording may have more numbers than
/// CSV takes. Throws Error where csv is named and the recording has more.
FileKinds files_for(const LoadedModel& model, const std::optional<FileKinds>& named);

/// A kind of file by its name, which is the ending; nothing for another word.
std::optional<FileKind> file_kind(const std::string& name);
/// "csv, mat, h5, mcap".
std::string file_kind_names();

/// "signals.csv" and those of the other kinds.
std::vector<std::string> signal_file_names(const FileKinds& kinds);

/// A recording as signals.csv has it.
std::string signals_csv(const record::Recording& recording);

/// A file with a place for each run, whose runs are added one by one, in their order.
class RunFile {
 public:
  virtual ~RunFile() = default;
  virtual void add(const table::RunView& run) = 0;
  /// Gives the file its name.
  virtual void finish() = 0;
};

/// Is a file of this kind one of runs? Others have one table of all.
bool has_runs(FileKind kind);
/// "DIR/signals.h5", and "DIR/signals-2.h5" of the second recording.
std::string signals_path(const std::string& folder, FileKind kind, std::size_t recording);
/// Begins a file of runs. It and its methods throw EnvironmentError.
std::unique_ptr<RunFile> open_run_file(const std::string& path, FileKind kind, const std::string& title);

/// "signals.csv would have 6e+07 numbers ...": which CSV files are left out, and what is written in their
/// place; empty where none is.
std::string csv_left_out(const std::vector<record::Recording>& recordings, const FileKinds& kinds);

/// Writes what was recorded into a folder: signals.csv, signals-2.csv, ... for further periods, and so for
/// each kind. HDF5 is written in the place of a CSV file that would be too large. Each file appears whole or not at all. Throws EnvironmentError.
void write_signals(const std::string& folder, const LoadedModel& model,
                   const std::vector<record::Recording>& recordings, const FileKinds& kinds);

}  // namespace stepwire::session
