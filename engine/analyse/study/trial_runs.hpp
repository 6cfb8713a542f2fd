#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "engine/analyse/statistics/circle.hpp"
#include "engine/analyse/study/study_request.hpp"
#include "engine/simulate/run/run_pool.hpp"

namespace stepwire::study {

/// Returns a pseudo-random whole number below 1e9, a hash of its arguments. It is used for the subject, the
/// noise of a trial and the order of the conditions.
std::uint64_t drawn_number(std::initializer_list<std::uint64_t> from);

/// Inputs of the trials: their file, and how it is run.
struct TrialSource {
  diagram::Loader& loader;
  std::string file;
  std::vector<diagram::Setting> settings;                       ///< Settings of the call.
  run::ExecutionMode engine = run::ExecutionMode::interpreted;  ///< Automatic: compilation proceeds during
                                                                ///< the first runs, and later runs use it.
  plan::CodeSource* code = nullptr;              ///< Compiler for runs that are not interpreted.
  unsigned threads = 0;                          ///< 0: all cores.
  const std::atomic<bool>* interrupt = nullptr;  ///< Once true, no further run begins.
  std::vector<run::RunObserver*> observers{};    ///< Observers of every attempt, by the trial's number.
};

/// Values of parameters in SI, by the parameters of StudyRequest::carry; a list has several numbers.
using CarriedNumbers = std::vector<std::vector<double>>;

/// A trial of an experiment, with its run.
struct TrialRun {
  std::uint64_t seed = 0;     ///< Seed of the experiment.
  std::size_t study = 0;      ///< Point of the file's sweep; 0 without one.
  std::size_t subject = 0;    ///< Number of the person.
  std::size_t condition = 0;  ///< Index of the condition in the request.
  std::size_t practice = 0;   ///< Number of the practice trial, from 1; 0: a scored trial.
  std::size_t order = 0;      ///< Number among the person's scored trials, from 1.
  std::size_t attempts = 1;
  bool done = false;                    ///< True: an attempt ended by `stop_when`.
  std::vector<std::string> failures{};  ///< Reasons of the failed attempts.
  run::SweepPoint point{};              ///< Settings of this run in TrialRuns::family().
  run::RunResult result{};
  CarriedNumbers begun{}, left{};  ///< Carried values before and after the trial.
  double end = 0.0;                ///< Time of its end [s].
  Eigen::Vector2d end_point =
      Eigen::Vector2d::Zero();  ///< Position at the end [m]; not necessarily a recorded row.
};

/// Values that a trial receives from the trials before it.
struct HandedOver {
  std::optional<statistics::Circle> circle;  ///< Task 1, once it is fitted.
  std::vector<diagram::Setting> carried;     ///< Empty in the first trial.
};

/// Returns "subject 3, condition HV".
std::string name_of(const TrialRun& trial, const StudyRequest& request);

/// Returns the number of studies of a file: one per point of its sweep, or 1.
std::size_t study_count(const run::Job& job);
/// Returns the diagram of a study, with the values of its point.
diagram::Diagram diagram_of(const run::Job& job, std::size_t study);
/// Returns the swept values of a study for titles: " with half_width=1 mm, offset=5 N"; empty without a
/// sweep.
std::string with_swept(const run::Job& job, std::size_t study);

/// Runner of a file's trials. Trials that differ in numbers only share a plan and its compiled code.
class TrialRuns {
 public:
  /// `job` has the points of the sweep; `job` and request must outlive the runs. `experiments` is their
  /// number.
  TrialRuns(TrialSource source, const StudyRequest& request, const run::Job& job,
            std::size_t experiments = 1);

  /// Runs a trial; seed, study, subject, condition and practice are given. An attempt that does not end by
  /// `stop_when` is repeated with another noise. May be called from any thread; the bits are the same. Throws
  /// Error if the diagram refuses a setting.
  void run(TrialRun& trial, const HandedOver& handed);
  /// Returns the values that a trial passes to the next one.
  std::vector<diagram::Setting> carried(const TrialRun& trial) const;

  run::LaneReport lanes() const { return pool_->lanes(); }
  bool interrupted() const { return source_.interrupt && *source_.interrupt; }
  /// Calls task(0) to task(count - 1), several in parallel.
  void in_parallel(std::size_t count, const std::function<void(std::size_t)>& task) {
    pool_->in_parallel(count, pool_->threads(source_.threads), task);
  }
  /// Returns the plans of the trials.
  const std::shared_ptr<run::PlanFamily>& family() const { return family_; }
  /// Returns an empty family of the same file.
  std::shared_ptr<run::PlanFamily> new_family() const;
  unsigned threads() const { return source_.threads; }

 private:
  std::vector<diagram::Setting> settings_of(const TrialRun& trial, const HandedOver& handed) const;
  std::uint64_t noise_of(const TrialRun& trial) const;
  void plan(TrialRun& trial, const HandedOver& handed);
  void find_members();
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
  std::optional<run::RunPool> pool_;
  std::jthread ahead_;  ///< Compiles during the first trials. Last member, since it uses the others.
};

/// A person of an experiment, at a point of the file's sweep.
struct Person {
  std::uint64_t seed = 0;  ///< Seed of the experiment.
  std::size_t study = 0, subject = 0;
};

/// Returns the number of people of an experiment over all points of the sweep; each point has people of its
/// own.
std::size_t people_of(const StudyRequest& request, const run::Job& job);
/// Returns the person of a number in the experiment of a seed.
Person person_of(const StudyRequest& request, std::uint64_t seed, std::size_t number);

/// Runs the trials of a person in sequence: practice, then the conditions in this person's order. Carried
/// values are passed from each trial to the next, and the circle of the first one to the others. A trial that
/// fails in all attempts is left out and carries nothing. If it is the one of the circle, the person has no
/// further trials. An interruption ends the list with the interrupted trial. The callback runs after each
/// trial. Throws Error.
std::vector<TrialRun> run_person(TrialRuns& runs, const StudyRequest& request, const Person& person,
                                 const std::function<void()>& told);

/// Returns the order of a subject's trials, as indices of conditions: fixed first ones, then the others in a
/// random order.
std::vector<std::size_t> order_of_conditions(const StudyRequest& request, std::uint64_t seed,
                                             std::size_t subject);

/// Returns the path of a run from its recording, with its end point.
Trial trial_of(const TrialRun& run, const StudyRequest& request);

}  // namespace stepwire::study
