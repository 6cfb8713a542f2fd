#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "engine/analyse/estimation/fit_request.hpp"
#include "engine/analyse/estimation/sensitive_subdiagram.hpp"
#include "engine/model/diagram/load.hpp"
#include "engine/simulate/run/drive.hpp"
#include "engine/simulate/run/run_meeting.hpp"

namespace stepwire::estimation {

/// Inputs of the runs of a fit besides the request.
struct ModelSource {
  diagram::Loader& loader;
  std::string file;
  std::vector<diagram::Setting> settings{};      ///< Settings of the call.
  plan::CodeSource* code = nullptr;              ///< Compiler of the plans; nullptr: interpreted.
  const std::atomic<bool>* interrupt = nullptr;  ///< Once true, runs end without a recording.
};

/// The runs of a file's records at any values of the fitted parameters. Each record has one plan, whose
/// executors are reused. Where possible, only the blocks that the parameters affect run, and the signals that
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
  bool compiled() const { return compiled_; }
  /// True if only a part of the diagram runs and the rest is replayed.
  bool in_part() const { return part_.has_value(); }
  /// Calls task(0) to task(count - 1), which may call run(), on `cores` threads (0: all).
  void in_parallel(std::size_t count, unsigned cores, const std::function<void(std::size_t)>& task) const {
    meeting_->in_parallel(count, meeting_->threads(cores), task);
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
  /// The plan of one record: the part, or the whole diagram.
  struct Record {
    Record(plan::Plan of, const std::vector<std::string>& names)
        : plan(std::move(of)), varied(plan.diagram, names) {}
    plan::Plan plan;
    diagram::Variation varied;  ///< Variation of the fitted parameters.
    std::optional<plan::CompiledPlan> code;
    std::mutex mutex;
    std::vector<std::unique_ptr<run::Executor>> idle;
  };

  diagram::Diagram load(std::size_t record, const Values& values) const;
  plan::Plan plan(std::size_t record, const Values& values) const {
    return plan::make_plan(load(record, values));
  }
  std::vector<std::string> names() const;
  std::vector<diagram::Assignment> assignments(const Values& values) const;
  void find_part();
  bool play_in(std::size_t record, const plan::Plan& whole);
  void make_records();
  run::TogetherRuns::Members compile_all();
  diagram::Variation variation(const Record& record) const;
  std::vector<plan::VariableBlock> variable(const Record& record) const;
  /// Returns an executor at time 0 with these values; nullptr if they need another plan. Throws Error for
  /// refused values.
  std::unique_ptr<run::Executor> begin(Record& record, const Values& values) const;
  void give_back(Record& record, std::unique_ptr<run::Executor> run) const;
  /// Runs to the end and returns the recordings; an empty list after a fault.
  std::vector<record::Recording> take(std::size_t record, run::Executor& simulation, std::string* fault,
                                      run::RunObserver* observer = nullptr) const;
  bool meet(run::PendingRun& run) const;
  void go_alone(run::PendingRun& run, run::RunObserver* observer) const;
  std::vector<record::Recording> complete(std::size_t record, std::vector<record::Recording> moved) const;

  ModelSource source_;
  const run::Job& job_;
  const FitRequest& request_;
  std::vector<std::string> labels_;
  std::vector<std::vector<table::Column>> swept_;
  std::vector<std::unique_ptr<Record>> records_;
  bool compiled_ = false;
  std::unique_ptr<run::RunMeeting> meeting_;  ///< nullptr until the records have plans.
  std::optional<SensitiveSubdiagram> part_;
  std::vector<std::vector<double>> tapes_;  ///< [record]: signals that the part reads, tick by tick.
  std::vector<std::vector<record::Recording>> still_;  ///< [record]: compared columns that do not change.
  mutable std::mutex loading_;
};

/// Returns the settings that give the parameters these values.
std::vector<diagram::Setting> settings_of(const std::vector<FitParameter>& parameters, const Values& values);

}  // namespace stepwire::estimation
