#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "engine/analyse/statistics/circle.hpp"
#include "engine/analyse/study/study_request.hpp"
#include "engine/simulate/run/run_meeting.hpp"

namespace stepwire::study {

/// The file whose runs are the trials, and how they are run.
struct TrialSource {
  diagram::Loader& loader;
  std::string file;
  std::vector<diagram::Setting> settings;  ///< of the call
  run::ExecutionMode engine =
      run::ExecutionMode::interpreted;  ///< automatic: what is compiled beside the first runs serves the rest
  plan::CodeSource* code = nullptr;     ///< of what is not interpreted
  unsigned threads = 0;                 ///< 0: all cores
  const std::atomic<bool>* interrupt = nullptr;  ///< once true, nothing more is begun
  std::vector<run::RunObserver*> observers{};    ///< of every attempt of every trial, by the trial's number
};

/// Values of parameters in SI, by the parameters of StudyRequest::carry; a list has several numbers.
using CarriedNumbers = std::vector<std::vector<double>>;

/// One trial of an experiment as it was run.
struct TrialRun {
  std::uint64_t seed = 0;     ///< of the experiment
  std::size_t study = 0;      ///< which point of the file's sweep; 0 without one
  std::size_t subject = 0;    ///< number of the person
  std::size_t condition = 0;  ///< index of the request's
  std::size_t practice = 0;   ///< which of those before the first one, from 1; 0: it counts
  std::size_t order = 0;      ///< which of the person's trials that count, from 1
  std::size_t attempts = 1;
  bool done = false;                    ///< by `stop_when`; else no attempt was
  std::vector<std::string> failures{};  ///< why each attempt before the last, or all of them, failed
  run::SweepPoint point{};              ///< of TrialRuns::family(): the settings of this run
  run::RunResult result{};
  CarriedNumbers begun{}, left{};                       ///< what it began with, and what it left
  double end = 0.0;                                     ///< when it was done [s]
  Eigen::Vector2d end_point = Eigen::Vector2d::Zero();  ///< and where [m], which need not be a recorded row
};

/// What a trial gets from those before it.
struct HandedOver {
  std::optional<statistics::Circle> circle;  ///< task 1, once it is fitted
  std::vector<diagram::Setting> carried;     ///< none in the first trial
};

/// "subject 3, condition HV".
std::string name_of(const TrialRun& trial, const StudyRequest& request);

/// The studies that a file asks for: one for each point of its sweep, or the one without.
std::size_t study_count(const run::Job& job);
/// The diagram of one of them, with the values of its point.
diagram::Diagram diagram_of(const run::Job& job, std::size_t study);
/// What sets it apart: " with half_width=1 mm, offset=5 N"; empty where there is no sweep.
std::string with_swept(const run::Job& job, std::size_t study);

/// Runs trials of a file. Trials that differ in numbers share a plan and a compilation.
class TrialRuns {
 public:
  /// `job` has the points of the sweep; it and the request must outlive the runs, of `experiments`
  /// experiments.
  TrialRuns(TrialSource source, const StudyRequest& request, const run::Job& job,
            std::size_t experiments = 1);

  /// Runs a trial of which seed, study, subject, condition and practice are given. What is not done within
  /// the file's `stop`, or breaks off, is run again with another noise. From any thread, to the same bits.
  /// Throws Error where the diagram refuses what is set.
  void run(TrialRun& trial, const HandedOver& handed);
  /// What it leaves to the next one.
  std::vector<diagram::Setting> carried(const TrialRun& trial) const;

  run::LaneReport lanes() const { return meeting_->lanes(); }
  bool interrupted() const { return source_.interrupt && *source_.interrupt; }
  /// Does task(0) to task(count - 1), which run trials, several at a time.
  void in_parallel(std::size_t count, const std::function<void(std::size_t)>& task) {
    meeting_->in_parallel(count, meeting_->threads(source_.threads), task);
  }
  /// The plans of the trials.
  const std::shared_ptr<run::PlanFamily>& family() const { return family_; }
  /// A family of the same file in which nothing was found yet.
  std::shared_ptr<run::PlanFamily> new_family() const;
  unsigned threads() const { return source_.threads; }

 private:
  std::vector<diagram::Setting> settings_of(const TrialRun& trial, const HandedOver& handed) const;
  std::uint64_t noise_of(const TrialRun& trial) const;
  void plan(TrialRun& trial, const HandedOver& handed);
  void find_members();
  std::vector<run::TieredExecution::Member> members() const;
  run::TogetherRuns::Members plans() const;
  run::RunEnd end_of(std::size_t member, run::PendingRun run);
  void compile_ahead();
  void find_member(TrialRun trial, HandedOver handed, double share);
  HandedOver file_values(const TrialRun& trial, double share) const;
  std::size_t number_of(const TrialRun& trial) const;
  void run_once(TrialRun& trial);
  void note_end(const run::Executor& run, TrialRun& trial) const;
  CarriedNumbers begun_with(const run::Executor& run) const;

  TrialSource source_;
  const StudyRequest& request_;
  const run::Job& job_;
  std::shared_ptr<run::PlanFamily> family_;
  run::IdleRuns idle_;
  std::optional<run::TieredExecution> changeover_;
  std::optional<run::RunMeeting> meeting_;
  std::jthread ahead_;  ///< compiles beside the first trials; last: it uses the others
};

}  // namespace stepwire::study
