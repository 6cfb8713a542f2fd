#pragma once

#include <functional>
#include <vector>

#include "engine/analyse/study/trial_runs.hpp"

namespace stepwire::study {

/// A person of an experiment, at a point of the file's sweep.
struct Person {
  std::uint64_t seed = 0;  ///< of the experiment
  std::size_t study = 0, subject = 0;
};

/// The people of an experiment at all points of the sweep, each of them a person.
std::size_t people_of(const StudyRequest& request, const run::Job& job);
/// One of these people of the experiment of a seed.
Person person_of(const StudyRequest& request, std::uint64_t seed, std::size_t number);

/// The trials of a person one after the other: practice, then the conditions in this person's order. Values
/// are carried from each to the next, and the circle of the first one is handed to the others. A trial that
/// is not done in any attempt is left out, and carries nothing on; behind one to which a circle is to be
/// fitted there are no others. Ends with a trial that the user interrupted. `told` is called behind each
/// trial. Throws Error.
std::vector<TrialRun> run_person(TrialRuns& runs, const StudyRequest& request, const Person& person,
                                 const std::function<void()>& told);

/// The order in which a subject does the trials, as indices of conditions: those that come first, the others
/// as drawn for this subject.
std::vector<std::size_t> order_of_conditions(const StudyRequest& request, std::uint64_t seed,
                                             std::size_t subject);

/// The path of a run: what it recorded, and where it was done.
Trial trial_of(const TrialRun& run, const StudyRequest& request);

}  // namespace stepwire::study
