#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "engine/analyse/statistics/circle.hpp"
#include "engine/analyse/study/study_request.hpp"
#include "engine/simulate/run/run.hpp"

namespace stepwire {

/// The file whose runs are the trials, and how they are run.
struct TrialSource {
  Loader& loader;
  std::string file;
  std::vector<Setting> settings;  ///< of the call
  ExecutionMode engine =
      ExecutionMode::interpreted;  ///< automatic: what is compiled beside the first runs serves the rest
  CodeSource* code = nullptr;      ///< of what is not interpreted
  unsigned threads = 0;            ///< 0: all cores
  const std::atomic<bool>* interrupt = nullptr;  ///< once true, nothing more is begun
  std::vector<RunObserver*> observers{};         ///< of every attempt of every trial, by the trial's number
};

/// One trial of an experiment as it was run.
struct TrialRun {
  std::size_t study = 0;      ///< which point of the file's sweep; 0 without one
  std::size_t subject = 0;    ///< number of the person
  std::size_t condition = 0;  ///< index of the request's
  std::size_t attempts = 1;
  bool done = false;                    ///< by `stop_when`; else no attempt was
  std::vector<std::string> failures{};  ///< why each attempt before the last, or all of them, failed
  SweepPoint point{};                   ///< of TrialRuns::family(): the settings of this run
  RunResult result{};
  double end = 0.0;                                     ///< when it was done [s]
  Eigen::Vector2d end_point = Eigen::Vector2d::Zero();  ///< and where [m], which need not be a recorded row
};

/// "subject 3, condition HV".
std::string name_of(const TrialRun& trial, const StudyRequest& request);

/// The studies that a file asks for: one for each point of its sweep, or the one without.
std::size_t study_count(const Job& job);
/// The diagram of one of them, with the values of its point.
Diagram diagram_of(const Job& job, std::size_t study);
/// What sets it apart: " with half_width=1 mm, offset=5 N"; empty where there is no sweep.
std::string with_swept(const Job& job, std::size_t study);

/// Whole numbers below 1e9 that follow from others, each as if drawn: who the subject is, the noise of a
/// trial, the order of the conditions.
std::uint64_t drawn_number(std::initializer_list<std::uint64_t> from);

/// Runs trials of a file in parallel. Trials that differ in numbers share a plan and a compilation.
class TrialRuns {
 public:
  /// The circles that the first trials of task 1 give, by study and subject.
  using Circles = std::map<std::pair<std::size_t, std::size_t>, Circle>;

  /// `job` has the points of the sweep; it and the request must outlive the runs.
  TrialRuns(TrialSource source, const StudyRequest& request, const Job& job);

  /// Runs trials of which study, subject and condition are given. What is not done within the file's `stop`,
  /// or breaks off, is run again with another noise. `told` is called for each run that has ended, from any
  /// thread. The same bits at any number of threads. Throws Error where the diagram refuses what is set.
  std::vector<TrialRun> run(std::uint64_t seed, std::vector<TrialRun> trials, const Circles& circles,
                            const std::function<void()>& told = {});

  /// The plans of the trials.
  const std::shared_ptr<PlanFamily>& family() const { return family_; }

 private:
  std::vector<Setting> settings_of(std::uint64_t seed, const TrialRun& trial, const Circles& circles) const;
  void plan(std::uint64_t seed, TrialRun& trial, const Circles& circles);
  std::vector<std::size_t> find_conditions();
  void compile_ahead(const std::vector<std::size_t>& members);
  Circles circles_to_come(const TrialRun& trial) const;
  void run_all(std::vector<TrialRun*>& trials, const std::function<void()>& told);
  std::size_t number_of(const TrialRun& trial) const;
  void run_one(TrialRun& trial, IdleRuns& idle, TieredExecution& changeover);
  void note_end(const Executor& run, TrialRun& trial) const;

  TrialSource source_;
  const StudyRequest& request_;
  const Job& job_;
  std::shared_ptr<PlanFamily> family_;
  std::jthread ahead_;  ///< compiles beside the first trials; last: it uses the others
};

}  // namespace stepwire
