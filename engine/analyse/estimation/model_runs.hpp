#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/estimation/fit_request.hpp"
#include "engine/analyse/estimation/sensitive_subdiagram.hpp"
#include "engine/model/diagram/load.hpp"
#include "engine/simulate/run/run_pool.hpp"

namespace stepwire::estimation {

/// Inputs of the runs of a fit besides the request.
struct ModelSource {
  diagram::Loader& loader;
  std::string file;
  std::vector<diagram::Setting> settings{};      ///< Settings of the call.
  plan::CodeSource* code = nullptr;              ///< Compiler of the plans; nullptr: interpreted.
  const std::atomic<bool>* interrupt = nullptr;  ///< Once true, runs end without a recording.
};

/// The runs of a file's records at any values of the fitted parameters. Each record has one plan in a
/// pool of runs. Where possible, only the blocks that the parameters affect run, and the signals that
/// these read are replayed from a tape.
class ModelRuns {
 public:
  /// Throws Error if the diagram refuses the start values.
  ModelRuns(ModelSource source, const run::Job& job, const FitRequest& request);

  std::size_t records() const { return labels_.size(); }
  /// Returns the label of a record, from its swept parameters: "10mm2Hz_0A"; empty for a single one.
  const std::string& label(std::size_t record) const { return labels_[record]; }
  /// Returns the swept parameters of a record, as columns of one row.
  const std::vector<table::Column>& swept(std::size_t record) const { return swept_[record]; }
  /// True if the runs are compiled.
  bool compiled() const { return pool_->compiled(); }
  /// True if only a part of the diagram runs and the rest is replayed.
  bool in_part() const { return part_.has_value(); }
  /// Calls task(0) to task(count - 1), which may call run(), on `cores` threads (0: all).
  void in_parallel(std::size_t count, unsigned cores, const std::function<void(std::size_t)>& task) const {
    pool_->in_parallel(count, pool_->threads(cores), task);
  }
  /// Returns the recordings of a run, with the swept parameters. On failure the list is empty and `fault`
  /// holds the reason. May be called from any thread.
  std::vector<record::Recording> run(std::size_t record, const Values& values,
                                     std::string* fault = nullptr) const;
  /// Makes the run with a plan of its own. Throws Error for refused values.
  std::vector<record::Recording> run_anew(std::size_t record, const Values& values, std::string* fault) const;
  /// Returns the reason why the diagram refuses the values; empty if it accepts them.
  std::string refusal(std::size_t record, const Values& values) const;

 private:
  std::unique_ptr<run::PlanFamily> new_family() const;
  std::vector<diagram::Setting> settings_at(std::size_t record) const;
  std::vector<std::string> names() const;
  run::RunOptions options() const;
  void plan_records();
  std::unique_ptr<run::PlanFamily> plan_part();
  bool record_tape(std::size_t record, run::RunPool& pool);
  void make_pool();
  /// Makes a run and returns its recordings; an empty list after a fault.
  std::vector<record::Recording> take(std::size_t record, run::RunPool& pool, const run::PooledRun& run,
                                      std::string* fault, run::RunObserver* observer = nullptr) const;
  std::vector<record::Recording> complete(std::size_t record, std::vector<record::Recording> moved) const;

  ModelSource source_;
  const run::Job& job_;
  const FitRequest& request_;
  std::vector<std::string> labels_;
  std::vector<std::vector<table::Column>> swept_;
  std::optional<SensitiveSubdiagram> part_;
  std::vector<std::vector<double>> tapes_;  ///< [record]: signals that the part reads, tick by tick.
  std::vector<std::vector<record::Recording>> still_;  ///< [record]: compared columns that do not change.
  std::unique_ptr<run::PlanFamily> family_;            ///< A member for each record.
  std::unique_ptr<run::RunPool> pool_;
};

/// Returns the settings that give the parameters these values.
std::vector<diagram::Setting> settings_of(const std::vector<FitParameter>& parameters, const Values& values);

}  // namespace stepwire::estimation
