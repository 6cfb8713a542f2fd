#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "engine/diagram/load.hpp"
#include "engine/identify/fit_request.hpp"
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
/// where the numbers of the plan are affine functions of the values; elsewhere each run is planned anew,
/// which is slower and gives the same.
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
  /// From now on plans each run anew.
  void plan_anew() { codes_.clear(); }

  /// All that a run records, with the swept parameters; nothing where it ends with a fault, which is told in
  /// `fault`. From any thread.
  std::vector<Recording> run(std::size_t record, const Values& values, std::string* fault = nullptr) const;
  /// The same from a plan of its own. Throws Error where the diagram refuses the values.
  std::vector<Recording> run_anew(std::size_t record, const Values& values, std::string* fault) const;
  /// Why the diagram refuses the values; empty where it takes them. Compiled runs go on with any.
  std::string refusal(std::size_t record, const Values& values) const;

 private:
  Plan plan(std::size_t record, const Values& values) const;
  std::vector<Recording> record(std::size_t record, Simulation& simulation, std::string* fault) const;

  ModelSource source_;
  const Job& job_;
  const FitRequest& request_;
  std::vector<std::string> labels_;
  std::vector<std::vector<Column>> swept_;
  std::vector<Plan> at_start_;
  std::vector<RecordCode> codes_;  ///< for each record; empty: planned anew
  mutable std::mutex loading_;
};

/// What sets these parameters to these values.
std::vector<Setting> settings_of(const std::vector<FitParameter>& parameters, const Values& values);

}  // namespace stepwire
