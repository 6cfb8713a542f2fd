#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/analyse/tuning/tune_request.hpp"
#include "engine/model/diagram/load.hpp"
#include "engine/simulate/run/pooling.hpp"
#include "engine/simulate/run/run_pool.hpp"

namespace stepwire::tuning {

/// Inputs of the runs of an optimisation besides the request.
struct TuneSource {
  diagram::Loader& loader;
  std::string file;
  std::vector<diagram::Setting> settings{};          ///< Settings of the call.
  const std::vector<linear::NamedAnalysis>& linear;  ///< Linear analyses of the file.
  plan::CodeSource* code = nullptr;                  ///< Compiler of the plans; nullptr: interpreted.
  const std::atomic<bool>* interrupt = nullptr;      ///< Once true, runs end without a recording.
  std::function<void(std::vector<record::Recording>&)>
      add_shown{};  ///< Adds the columns of the file's scene.
  /// Replaces the runs of the file, where these are the trials of a study. Returns the recordings at the
  /// given settings. On failure the list is empty and `fault` holds the reason.
  std::function<std::vector<record::Recording>(const std::vector<diagram::Setting>&, std::string& fault)>
      perform{};
};

/// Values of all tuned parameters, SI.
using Values = std::vector<double>;

/// All runs of a file at any values of the tuned parameters. Each structure of the sweep has one plan in a
/// pool of runs. Calls may come from any thread.
class TuneRuns {
 public:
  /// Job and request must outlive it.
  TuneRuns(TuneSource source, const run::Job& job, const TuneRequest& request);

  /// Returns the number of runs per evaluation; the trials of a study count as one.
  std::size_t count() const;
  /// Returns the swept values of a run: "load=2 kg"; empty for a single run.
  std::string label(std::size_t run) const;
  bool compiled() const { return pool_->compiled(); }
  /// Returns the pool of the runs, which also divides the cores among parallel searches.
  run::RunPool& pool() const { return *pool_; }
  bool interrupted() const { return source_.interrupt && *source_.interrupt; }
  /// Makes all runs and pools their recordings in the order of the sweep. Adds the linear analyses that the
  /// request reads. Returns an empty list if a run fails or refuses the values; `fault` holds the reason.
  std::vector<record::Recording> run(const Values& values, unsigned threads, std::string& fault) const;

 private:
  using Recordings = std::vector<record::Recording>;

  std::vector<diagram::Setting> settings_at(std::size_t point, const Values& values) const;
  void plan_points();
  void add_differences();
  void make_pool();
  bool is_structural() const;
  Recordings performed(const Values& values, std::string& fault) const;
  Recordings run_point(std::size_t point, const Values& values, std::string& fault) const;
  Recordings take(std::size_t point, const Values& values, std::string& fault) const;
  void add_analyses(const run::Executor& simulation, Recordings& recordings) const;
  void add_parameters(const Values& values, Recordings& recordings) const;

  TuneSource source_;
  const run::Job& job_;
  const TuneRequest& request_;
  run::SweptColumns swept_;
  std::vector<bool> analysed_;  ///< True for analyses that the request reads.
  std::vector<bool> recorded_;  ///< True for tuned parameters that it reads.
  run::PlanFamily family_;
  std::vector<std::size_t> members_;  ///< Member of the family of each point.
  std::unique_ptr<run::RunPool> pool_;
};

/// Returns the start values of the parameters.
Values start_of(const std::vector<TuneParameter>& parameters);
/// Returns the settings that give the parameters these values.
std::vector<diagram::Setting> settings_of(const std::vector<TuneParameter>& parameters, const Values& values);

}  // namespace stepwire::tuning
