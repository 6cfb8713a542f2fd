#pragma once

#include <functional>
#include <vector>

#include "engine/analyse/study/trial_runs.hpp"

namespace stepwire::study {

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
