#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "engine/diagram/load.hpp"
#include "engine/identify/fit_request.hpp"
#include "engine/identify/moved_part.hpp"
#include "engine/identify/shared_code.hpp"
#include "engine/run/run.hpp"

namespace stepwire {

/// What a fit's runs need beside the request.
struct ModelSource {
  Loader& loader;
  std::string file;
  std::vector<Setting> settings{};               ///< of the call
  CodeSource* code = nullptr;                    ///< null: interpreted
  const std::atomic<bool>* interrupt = nullptr;  ///< once true, runs end and give nothing
};

/// The runs of a file's records with any values of the fitted parameters. One compilation serves all of them
/// where the numbers of the plan are affine functions of the values; elsewhere each run is planned anew and
/// takes its numbers from there, which is slower and gives the same. Where it can be told apart, only the
/// part of the diagram that the parameters move is run, and what it reads of the rest is played back.
class ModelRuns {
 public:
  /// Throws Error where the diagram refuses the start values.
  ModelRuns(ModelSource source, const Job& job, const FitRequest& request);

  std::size_t records() const { return at_start_.size(); }
  /// What tells a record from the others: "10mm2Hz_0A"; empty for the only one.
  const std::string& label(std::size_t record) const { return labels_[record]; }
  /// Its swept parameters, one row.
  const std::vector<Column>& swept(std::size_t record) const { return swept_[record]; }
  /// Does one compilation serve all runs?
  bool compiled() const { return !codes_.empty(); }
  /// Is only a part of the diagram run, and the rest played back?
  bool in_part() const { return part_.has_value(); }
  /// From now on plans each run anew.
  void plan_anew() { codes_.clear(); }
  /// Does one compilation serve all runs, each of which is planned?
  bool planned() const { return planned_.has_value(); }

  /// All that a run records, with the swept parameters; nothing where it ends with a fault, which is told in
  /// `fault`. From any thread.
  std::vector<Recording> run(std::size_t record, const Values& values, std::string* fault = nullptr) const;
  /// The same from a plan of its own. Throws Error where the diagram refuses the values.
  std::vector<Recording> run_anew(std::size_t record, const Values& values, std::string* fault) const;
  /// Why the diagram refuses the values; empty where it takes them. Compiled runs go on with any.
  std::string refusal(std::size_t record, const Values& values) const;

 private:
  Diagram load(std::size_t record, const Values& values) const;
  Plan plan(std::size_t record, const Values& values) const { return make_plan(load(record, values)); }
  /// Of what is run for each value: the part, or all of it.
  Plan plan_run(std::size_t record, const Values& values) const;
  /// Code for one run; `own` is its plan where it has one.
  std::optional<CompiledPlan> code_of(std::size_t record, const Values& values,
                                      const std::optional<Plan>& own) const;
  void find_part();
  bool play_in(std::size_t record);
  /// Runs to the end and takes all that is recorded; nothing after a fault.
  std::vector<Recording> take(std::size_t record, Simulation& simulation, std::string* fault,
                              const std::function<void()>& before_tick = {},
                              const std::function<void()>& after_tick = {}) const;
  std::vector<Recording> complete(std::size_t record, std::vector<Recording> moved) const;

  ModelSource source_;
  const Job& job_;
  const FitRequest& request_;
  std::vector<std::string> labels_;
  std::vector<std::vector<Column>> swept_;
  std::vector<Plan> at_start_;  ///< of what is run
  std::optional<MovedPart> part_;
  std::vector<std::vector<double>> tapes_;     ///< [record]: what the part reads, tick by tick
  std::vector<std::vector<Recording>> still_;  ///< [record]: what is compared and does not move
  std::vector<RecordCode> codes_;              ///< for each record; empty: planned anew
  std::optional<PlannedCode> planned_;         ///< for what is planned anew; none: interpreted
  mutable std::mutex loading_;
};

/// What sets these parameters to these values.
std::vector<Setting> settings_of(const std::vector<FitParameter>& parameters, const Values& values);

}  // namespace stepwire
