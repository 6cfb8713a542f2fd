#include "engine/app/session/signal_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/app/session/run_views.hpp"
#include "engine/base/hdf5/hdf5_writer.hpp"
#include "engine/base/mat/mat_file.hpp"
#include "engine/base/mcap/mcap_writer.hpp"
#include "engine/base/table/table_file.hpp"

namespace stepwire::session {

namespace {

/// What writes one recording to a path.
struct Kind {
  FileKind kind;
  const char* name;
  void (*write)(const std::string& path, const LoadedModel& model, const record::Recording& recording);
};

/// Swept words stand in their column as numbers: a MAT file keeps these, a table for people has the words.
void write_csv(const std::string& path, const LoadedModel&, const record::Recording& recording) {
  table::ColumnWords words;
  for (const record::Categories& column : recording.categories)
    for (const std::string& text : column.texts) words[column.column].push_back(unquoted(text));
  table::write_csv(path, recording.table, words);
}

void write_mat(const std::string& path, const LoadedModel&, const record::Recording& recording) {
  mat::write_mat(path, recording.table);
}

template <class Writer>
void write_runs(const std::string& path, const LoadedModel& model, const record::Recording& recording) {
  Writer writer(path, model.job.plan.diagram.title);
  const RunViews views(model, recording);
  for (std::size_t run = 0; run < views.count(); ++run) writer.add(views.view(run));
  writer.finish();
}

constexpr std::array kinds_of_files{Kind{FileKind::csv, "csv", write_csv},
                                    Kind{FileKind::mat, "mat", write_mat},
                                    Kind{FileKind::h5, "h5", write_runs<hdf5::Hdf5Writer>},
                                    Kind{FileKind::mcap, "mcap", write_runs<mcap::McapWriter>}};

const Kind& row_of(FileKind kind) {
  return *std::ranges::find(kinds_of_files, kind, &Kind::kind);
}

}  // namespace

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

void write_signals(const std::string& folder, const LoadedModel& model,
                   const std::vector<record::Recording>& recordings, const FileKinds& kinds) {
  for (std::size_t i = 0; i < recordings.size(); ++i)
    for (const FileKind kind : kinds) {
      const Kind& row = row_of(kind);
      row.write(folder + "/" + io::numbered("signals", i, fmt::format(".{}", row.name)), model,
                recordings[i]);
    }
}

}  // namespace stepwire::session
