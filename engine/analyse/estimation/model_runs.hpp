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

/// What a fit's runs need beside the request.
struct ModelSource {
  diagram::Loader& loader;
  std::string file;
  std::vector<diagram::Setting> settings{};      ///< of the call
  plan::CodeSource* code = nullptr;              ///< null: interpreted
  const std::atomic<bool>* interrupt = nullptr;  ///< once true, runs end and give nothing
};

/// The runs of a file's records with any values of the fitted parameters, which are set in the runs of one
/// plan for each record. Where that is possible, only the part of the diagram that the parameters move is
/// run, and what it reads of the rest is played back.
class ModelRuns {
 public:
  /// Throws Error where the diagram refuses the start values.
  ModelRuns(ModelSource source, const run::Job& job, const FitRequest& request);

  std::size_t records() const { return labels_.size(); }
  /// What tells a record from the others: "10mm2Hz_0A"; empty for the only one.
  const std::string& label(std::size_t record) const { return labels_[record]; }
  /// Its swept parameters, one row.
  const std::vector<table::Column>& swept(std::size_t record) const { return swept_[record]; }
  /// Are the runs compiled?
  bool compiled() const { return compiled_; }
  /// Is only a part of the diagram run, and the rest played back?
  bool in_part() const { return part_.has_value(); }
  /// Does task(0) to task(count - 1), which call run(), on so many cores (0: all).
  void in_parallel(std::size_t count, unsigned cores, const std::function<void(std::size_t)>& task) const {
    meeting_->in_parallel(count, meeting_->threads(cores), task);
  }
  /// All that a run records, with the swept parameters; nothing where it ends with a fault, which `fault`
  /// then says. From any thread.
  std::vector<record::Recording> run(std::size_t record, const Values& values,
                                     std::string* fault = nullptr) const;
  /// The same from a plan of its own. Throws Error where the diagram refuses the values.
  std::vector<record::Recording> run_anew(std::size_t record, const Values& values, std::string* fault) const;
  /// Why the diagram refuses the values; empty where it takes them.
  std::string refusal(std::size_t record, const Values& values) const;

 private:
  /// What is run of one record: the part, or all of it.
  struct Record {
    Record(plan::Plan of, const std::vector<std::string>& names)
        : plan(std::move(of)), varied(plan.diagram, names) {}
    plan::Plan plan;
    diagram::Variation varied;  ///< the fitted parameters
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
  /// A run at time 0 with these values; null where they need another plan. Throws Error for refused ones.
  std::unique_ptr<run::Executor> begin(Record& record, const Values& values) const;
  void give_back(Record& record, std::unique_ptr<run::Executor> run) const;
  /// Runs to the end and takes all that is recorded; nothing after a fault.
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
  std::unique_ptr<run::RunMeeting> meeting_;  ///< null until the records have plans
  std::optional<SensitiveSubdiagram> part_;
  std::vector<std::vector<double>> tapes_;             ///< [record]: what the part reads, tick by tick
  std::vector<std::vector<record::Recording>> still_;  ///< [record]: what is compared and does not move
  mutable std::mutex loading_;
};

/// What sets these parameters to these values.
std::vector<diagram::Setting> settings_of(const std::vector<FitParameter>& parameters, const Values& values);

}  // namespace stepwire::estimation
