#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "engine/analyse/tuning/tune_request.hpp"
#include "engine/model/diagram/load.hpp"
#include "engine/simulate/run/pooling.hpp"
#include "engine/simulate/run/run_meeting.hpp"

namespace stepwire::tuning {

/// What a tuning's runs need beside the request.
struct TuneSource {
  diagram::Loader& loader;
  std::string file;
  std::vector<diagram::Setting> settings{};                          ///< of the call
  const std::vector<linear::NamedAnalysis>& linear;                  ///< of the file
  plan::CodeSource* code = nullptr;                                  ///< null: interpreted
  const std::atomic<bool>* interrupt = nullptr;                      ///< once true, runs end and give nothing
  std::function<void(std::vector<record::Recording>&)> add_shown{};  ///< what the file's scene makes of them
  /// Makes the recordings with such settings in place of the runs of the file, where these are the trials of
  /// a study; `fault` is why there are none.
  std::function<std::vector<record::Recording>(const std::vector<diagram::Setting>&, std::string& fault)>
      perform{};
};

/// Values of all tuned parameters, SI.
using Values = std::vector<double>;

/// All runs of a file with any values of the tuned parameters, which are set in the runs of one plan for each
/// structure that the sweep has. Calls may come from any thread.
class TuneRuns {
 public:
  /// The job and the request must outlive it.
  TuneRuns(TuneSource source, const run::Job& job, const TuneRequest& request);
  ~TuneRuns();

  /// Runs of one evaluation; those of a study count as one.
  std::size_t count() const;
  /// The swept values of a run: "load=2 kg"; empty for the only one.
  std::string label(std::size_t run) const;
  bool compiled() const { return compiled_; }
  /// Runs of a search may go beside each other with those of others, on so many threads of so many cores.
  run::RunMeeting& meeting() const { return *meeting_; }
  bool interrupted() const { return source_.interrupt && *source_.interrupt; }
  /// What all runs record, pooled in the order of the sweep, with the linear analyses that the request reads;
  /// nothing where one of them ends with a fault or refuses the values, which `fault` then has.
  std::vector<record::Recording> run(const Values& values, unsigned threads, std::string& fault) const;

 private:
  struct Structure;
  using Recordings = std::vector<record::Recording>;

  Recordings performed(const Values& values, std::string& fault) const;
  void make_structures();
  std::vector<std::string> names_at(std::size_t point, const plan::Plan& plan) const;
  run::TogetherRuns::Members compile();
  Structure& structure_of(std::size_t point) const;
  std::vector<diagram::Assignment> assignments(std::size_t point, const Values& values) const;
  Recordings run_point(std::size_t point, const Values& values, std::string& fault) const;
  Recordings run_anew(std::size_t point, const Values& values, std::string& fault) const;
  /// With others in `meeting`, which may be null.
  Recordings take(std::size_t point, const Values& values, run::Executor& simulation, std::string& fault,
                  run::RunMeeting* meeting = nullptr) const;
  void go_alone(run::PendingRun& run) const;
  void add_analyses(const run::Executor& simulation, Recordings& recordings) const;
  void add_parameters(const Values& values, Recordings& recordings) const;

  TuneSource source_;
  const run::Job& job_;
  const TuneRequest& request_;
  run::SweptColumns swept_;
  std::vector<bool> analysed_;  ///< which analyses the request reads
  std::vector<bool> recorded_;  ///< which tuned parameters it reads
  std::vector<std::unique_ptr<Structure>> structures_;
  std::vector<std::size_t> of_point_;  ///< structure of each point
  mutable std::mutex loading_;
  bool compiled_ = false;
  std::unique_ptr<run::RunMeeting> meeting_;
};

/// What sets these parameters to these values.
std::vector<diagram::Setting> settings_of(const std::vector<TuneParameter>& parameters, const Values& values);

}  // namespace stepwire::tuning
