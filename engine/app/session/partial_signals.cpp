#include "engine/app/session/partial_signals.hpp"

#include <filesystem>
#include <utility>

#include "engine/base/io/file.hpp"
#include "engine/simulate/record/recorder.hpp"

namespace stepwire::session {

namespace {

constexpr std::chrono::seconds before_first{2}, between_writes{1};

}  // namespace

/// File of one recording, with the rows that are not written yet.
struct PartialSignals::File {
  std::string path, title;
  std::vector<table::Column> rows;
  std::unique_ptr<hdf5::Hdf5Writer> writer;

  void take(std::span<const double> numbers) {
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].values.push_back(numbers[i]);
  }

  void write() {
    writer ? append() : begin();
    for (table::Column& column : rows) column.values.clear();
  }

 private:
  void begin() {
    writer = std::make_unique<hdf5::Hdf5Writer>(path, title);
    table::RunView run;
    for (const table::Column& column : rows) run.series.push_back({column.name, column.unit, column.values});
    writer->begin(run);
    writer->publish();
  }

  void append() {
    std::vector<std::span<const double>> columns;
    for (const table::Column& column : rows) columns.emplace_back(column.values);
    writer->append(columns);
    writer->flush();
  }
};

PartialSignals::PartialSignals(std::string folder, const LoadedModel& model)
    : due_(Clock::now() + before_first) {
  const plan::Plan& plan = model.job.plan;
  for (const diagram::RecordRequest& request : plan.diagram.records) {
    const std::string name = io::numbered("signals", files_.size(), ".h5.partial");
    files_.push_back(std::make_unique<File>(
        File{folder + "/" + name, plan.diagram.title, record::empty_columns(plan, request), nullptr}));
  }
}

PartialSignals::~PartialSignals() = default;

void PartialSignals::row(const run::ObservedRun&, std::size_t recording, std::span<const double> numbers) {
  if (refused_) return;
  files_[recording]->take(numbers);
  if (Clock::now() >= due_) write();
}

void PartialSignals::write() {
  try {
    for (const auto& file : files_) file->write();
  } catch (const std::exception&) {  // e.g. a full disk; the rows stay in memory until the end
    refused_ = true;
  }
  due_ = Clock::now() + between_writes;
}

void PartialSignals::remove() {
  for (const auto& file : files_) {
    if (!std::exchange(file->writer, nullptr)) continue;
    std::error_code none;
    std::filesystem::remove(file->path, none);
  }
}

}  // namespace stepwire::session
