#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/app/session/loaded_model.hpp"
#include "engine/simulate/record/recording.hpp"

namespace stepwire::session {

/// Kinds of files that a run leaves its numbers and pictures in, as the option --files names them.
enum class FileKind { csv, mat, h5, mcap };
using FileKinds = std::vector<FileKind>;

/// Those that a call has which names none.
inline const FileKinds usual_files{FileKind::csv, FileKind::mat};

/// A kind of file by its name, which is the ending; nothing for another word.
std::optional<FileKind> file_kind(const std::string& name);
/// "csv, mat, h5, mcap".
std::string file_kind_names();

/// "signals.csv" and those of the other kinds.
std::vector<std::string> signal_file_names(const FileKinds& kinds);

/// A recording as signals.csv has it.
std::string signals_csv(const record::Recording& recording);

/// Writes what was recorded into a folder: signals.csv, signals-2.csv, ... for further periods, and so for
/// each kind. Each file appears whole or not at all. Throws EnvironmentError.
void write_signals(const std::string& folder, const LoadedModel& model,
                   const std::vector<record::Recording>& recordings, const FileKinds& kinds);

}  // namespace stepwire::session
