#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/query/symbol_table.hpp"
#include "engine/analyse/study/path_errors.hpp"
#include "engine/analyse/study/published.hpp"
#include "engine/base/yaml/key.hpp"
#include "engine/model/diagram/load.hpp"
#include "engine/model/plan/plan.hpp"

namespace stepwire::study {

/// A condition of a study: what it sets in the diagram, and which feedbacks that switches on.
struct StudyCondition {
  FeedbackCondition feedback;
  std::vector<diagram::Setting> settings;
};

/// Task 1: which condition is drawn first, and which parameters of the other trials take the circle that is
/// fitted to it.
struct CircleHandover {
  std::string of;  ///< the condition, "NO"
  std::string x, y, radius;
};

/// Task 2: the signals between which the way back (equation 24) is found as a function of the place.
struct WayBackSignals {
  diagram::SignalRef position, direction;
  yaml::Place place;
};

/// What a person takes from each trial into the next: the last value of a signal becomes that of a parameter.
struct CarriedValue {
  std::string parameter;
  std::string signal;  ///< its name in the diagram
  yaml::Place place;
};

/// The section `study` of a diagram file: a human-subject study whose trials are runs of the file.
struct StudyRequest {
  std::string task;                   ///< "1": drawing a circle, "2": returning
  std::vector<std::size_t> subjects;  ///< numbers of people, from 1
  std::uint64_t seed = 1;             ///< which people they are, and all that is random
  std::string subject_parameter;      ///< that takes the person
  std::string seed_parameter;         ///< that takes the noise of a trial
  std::vector<StudyCondition> conditions;
  std::string position;       ///< a recorded signal of two elements
  std::size_t recording = 0;  ///< that has it
  std::optional<CircleHandover> circle;
  std::optional<WayBackSignals> way_back;
  std::vector<std::size_t> first;     ///< conditions that come first, in this order; the others as drawn
  std::vector<std::size_t> practice;  ///< conditions of the trials before the first one, which do not count
  std::vector<CarriedValue> carry;
  std::size_t experiments = 1;  ///< with other people each: seeds from `seed` on; the first one is drawn
  std::size_t attempts = 10;    ///< runs of one trial at most, until one ends by `stop_when`
  std::string trials;           ///< a CSV file of recorded trials in place of the runs; empty: none
  std::vector<Trial> recorded;  ///< in it, by subject, conditions in the order of the request
  PublishedStudy published;     ///< what its tables set beside its own numbers
  yaml::Place place;

  /// Names of the subjects in order: those of the recorded trials, or the numbers.
  std::vector<std::string> subject_names() const;
  std::vector<std::string> condition_names() const;
  std::vector<FeedbackCondition> feedbacks() const;
};

/// What a call asks of a study in place of the file's words.
struct StudyWords {
  std::optional<std::size_t> subjects{};  ///< how many
  std::optional<std::uint64_t> seed{};
  std::optional<std::size_t> experiments{};  ///< how many
  std::string trials{};                      ///< a CSV file
};

/// The keys of the section `study`.
const yaml::Key& study_form();

/// Reads the value under the key `study`. `like` takes the section from another file, in which the keys given
/// here replace those of the same name. Everything that is wrong goes to `faults`; what is returned then is
/// of no use. Throws TableError and EnvironmentError for a file of trials that cannot be read.
StudyRequest read_study(const yaml::Node& node, const query::SymbolTable& names,
                        const diagram::Diagram& diagram, diagram::Loader& loader, const StudyWords& words,
                        yaml::Faults& faults);

/// Parameter and signal of what is carried have the same unit and as many elements.
void check_carry(const StudyRequest& request, const plan::Plan& plan, yaml::Faults& faults);

/// Parameters that have a value of their own in each trial, whatever the file has.
std::vector<std::string> set_for_each_trial(const StudyRequest& request);

/// Nothing that the study sets for each trial but what is carried can be swept; recorded trials have no
/// sweep.
void check_sweep(const StudyRequest& request, const diagram::Diagram& diagram, yaml::Faults& faults);

/// Reads the file of recorded trials: those of the request's task, sorted. Trials of conditions that the
/// study does not have go to `faults`. Throws TableError and EnvironmentError.
void read_recorded(StudyRequest& request, yaml::Faults& faults);

}  // namespace stepwire::study
