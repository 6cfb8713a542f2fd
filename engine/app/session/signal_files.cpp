#include "engine/app/session/signal_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/app/session/run_views.hpp"
#include "engine/base/hdf5/hdf5_writer.hpp"
#include "engine/base/mat/mat_file.hpp"
#include "engine/base/mcap/mcap_writer.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/simulate/run/memory.hpp"

namespace stepwire::session {

namespace {

/// File format, with a writer of a recording or an opener of a file of runs.
struct Kind {
  FileKind kind;
  const char* name;
  void (*write)(const std::string& path, const record::Recording& recording);
  std::unique_ptr<RunFile> (*open)(const std::string& path, const std::string& title);
};

/// Returns the texts of swept words. The columns have their numbers, which MAT files store; a CSV file has
/// the words.
table::ColumnWords words_of(const record::Recording& recording) {
  table::ColumnWords words;
  for (const record::Categories& column : recording.categories)
    for (const std::string& text : column.texts) words[column.column].push_back(without_quotes(text));
  return words;
}

void write_csv(const std::string& path, const record::Recording& recording) {
  table::write_csv(path, recording.table, words_of(recording));
}

void write_mat(const std::string& path, const record::Recording& recording) {
  mat::write_mat(path, recording.table);
}

template <class Writer>
class WrittenRuns : public RunFile {
 public:
  WrittenRuns(const std::string& path, const std::string& title) : writer_(path, title) {}
  void add(const table::RunView& run) override { writer_.add(run); }
  void finish() override { writer_.finish(); }

 private:
  Writer writer_;
};

template <class Writer>
std::unique_ptr<RunFile> open_runs(const std::string& path, const std::string& title) {
  return std::make_unique<WrittenRuns<Writer>>(path, title);
}

constexpr std::array kinds_of_files{Kind{FileKind::csv, "csv", write_csv, nullptr},
                                    Kind{FileKind::mat, "mat", write_mat, nullptr},
                                    Kind{FileKind::h5, "h5", nullptr, open_runs<hdf5::Hdf5Writer>},
                                    Kind{FileKind::mcap, "mcap", nullptr, open_runs<mcap::McapWriter>}};

const Kind& row_of(FileKind kind) {
  return *std::ranges::find(kinds_of_files, kind, &Kind::kind);
}

}  // namespace

std::string signals_csv(const record::Recording& recording) {
  return table::csv_text(recording.table, words_of(recording));
}

FileKinds files_for(const LoadedModel& model, const std::optional<FileKinds>& named) {
  const diagram::Diagram& diagram = model.job.plan.diagram;
  const double numbers = run::most_numbers(model.job);
  // The number of recorded values is unknown if a condition can stop the run.
  if (numbers <= most_numbers_of_csv || diagram.stop_when || model.study) return named.value_or(usual_files);
  if (!named) return {FileKind::h5};
  if (std::ranges::find(*named, FileKind::csv) == named->end()) return *named;
  throw yaml::Error(yaml::Fault{
      {model.file, {}},
      "--files",
      yaml::Message(fmt::format("csv takes {:.0f} million numbers, and {:.3g} million are recorded",
                                most_numbers_of_csv * 1e-6, numbers * 1e-6),
                    "name h5, or give 'record' an 'every'"),
      {}});
}

std::optional<FileKind> file_kind(const std::string& name) {
  const auto row = std::ranges::find(kinds_of_files, name, &Kind::name);
  if (row == kinds_of_files.end()) return std::nullopt;
  return row->kind;
}

std::string file_kind_names() {
  std::vector<std::string> names;
  for (const Kind& row : kinds_of_files) names.emplace_back(row.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::vector<std::string> signal_file_names(const FileKinds& kinds) {
  std::vector<std::string> names;
  for (const FileKind kind : kinds) names.push_back(fmt::format("signals.{}", row_of(kind).name));
  return names;
}

namespace {

bool leaves_out_csv(const record::Recording& recording, const FileKinds& kinds) {
  const double numbers =
      static_cast<double>(recording.table.rows()) * static_cast<double>(recording.table.columns.size());
  return numbers > most_numbers_of_csv && std::ranges::find(kinds, FileKind::csv) != kinds.end();
}

FileKinds written_kinds(const record::Recording& recording, FileKinds kinds) {
  if (!leaves_out_csv(recording, kinds)) return kinds;
  std::erase(kinds, FileKind::csv);
  if (std::ranges::find(kinds, FileKind::h5) == kinds.end()) kinds.push_back(FileKind::h5);
  return kinds;
}

}  // namespace

bool has_runs(FileKind kind) {
  return row_of(kind).open != nullptr;
}

std::string signals_path(const std::string& folder, FileKind kind, std::size_t recording) {
  return folder + "/" + io::numbered("signals", recording, fmt::format(".{}", row_of(kind).name));
}

std::unique_ptr<RunFile> open_run_file(const std::string& path, FileKind kind, const std::string& title) {
  return row_of(kind).open(path, title);
}

std::string csv_left_out(const std::vector<record::Recording>& recordings, const FileKinds& kinds) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < recordings.size(); ++i)
    if (leaves_out_csv(recordings[i], kinds)) names.push_back(io::numbered("signals", i, ".csv"));
  if (names.empty()) return {};
  return fmt::format("{}: more than {:.0f} million numbers; h5 is written in place of csv",
                     fmt::join(names, ", "), most_numbers_of_csv * 1e-6);
}

void write_signals(const std::string& folder, const LoadedModel& model,
                   const std::vector<record::Recording>& recordings, const FileKinds& kinds) {
  for (std::size_t i = 0; i < recordings.size(); ++i)
    for (const FileKind kind : written_kinds(recordings[i], kinds)) {
      const std::string path = signals_path(folder, kind, i);
      if (!has_runs(kind)) {
        row_of(kind).write(path, recordings[i]);
        continue;
      }
      const auto file = open_run_file(path, kind, model.job.plan.diagram.title);
      const RunViews views(model, recordings[i], 0, i);
      for (std::size_t run = 0; run < views.count(); ++run) file->add(views.view(run));
      file->finish();
    }
}

}  // namespace stepwire::session
