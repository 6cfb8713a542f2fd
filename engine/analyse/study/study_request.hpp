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

/// A condition of a study: its settings, and the factors that they switch on.
struct StudyCondition : Condition {
  std::vector<diagram::Setting> settings;
};

/// Drawing of a circle: the condition that is drawn first, and the parameters of the other trials that
/// receive its fitted circle.
struct CircleHandover {
  std::string of;  ///< Name of the condition: "NO".
  std::string x, y, radius;
};

/// Return to a region: signals between which the way back (equation 24) is a function of the position.
struct WayBackSignals {
  diagram::SignalRef position, direction;
  yaml::Place place;
};

/// A value that a person carries from each trial into the next: the last value of a signal becomes that of a
/// parameter.
struct CarriedValue {
  std::string parameter;
  std::string signal;  ///< Name in the diagram.
  yaml::Place place;
};

/// The section `study` of a diagram file: a human-subject study whose trials are runs of the file.
struct StudyRequest {
  std::string task;                   ///< Name of what people do, in titles and recorded trials.
  std::vector<std::size_t> subjects;  ///< Numbers of people, from 1.
  std::uint64_t seed = 1;             ///< Seed of the people and of all that is random.
  std::string subject_parameter;      ///< Parameter that receives the seed of the person.
  std::string seed_parameter;         ///< Parameter that receives the noise seed of a trial.
  std::vector<StudyCondition> conditions;
  std::string position;       ///< Name of a recorded signal with two elements.
  std::size_t recording = 0;  ///< Index of its recording.
  std::optional<CircleHandover> circle;
  std::optional<WayBackSignals> way_back;
  std::vector<std::size_t> first;     ///< Conditions in fixed order; the others follow in random order.
  std::vector<std::size_t> practice;  ///< Conditions of the practice trials, which are not scored.
  std::vector<CarriedValue> carry;
  std::size_t experiments = 1;  ///< Number of experiments, with other people each: seeds from `seed` on.
  std::size_t attempts = 10;    ///< Limit of runs per trial, until one ends by `stop_when`.
  std::string trials;           ///< CSV file of recorded trials that replace the runs; empty: none.
  std::vector<Trial> recorded;  ///< Recorded trials by subject, conditions in the order of the request.
  PublishedStudy published;     ///< Published numbers beside which the tables show ours.
  yaml::Place place;

  /// Returns the names of the subjects in order: those of the recorded trials, or the numbers.
  std::vector<std::string> subject_names() const;
  std::vector<std::string> condition_names() const;
  /// Returns the conditions with their factors.
  std::vector<Condition> factored() const;
};

/// Options of a call that replace values of the file.
struct StudyWords {
  std::optional<std::size_t> subjects{};  ///< Number of subjects.
  std::optional<std::uint64_t> seed{};
  std::optional<std::size_t> experiments{};  ///< Number of experiments.
  std::string trials{};                      ///< Path of a CSV file.
};

/// Returns the schema of the section `study`.
const yaml::Key& study_form();

/// Reads the value under the key `study`. With the key `like`, keys of another file are the defaults. Adds
/// all faults to `faults`; with faults the result must not be used. Throws TableError and EnvironmentError
/// for an unreadable file of trials.
StudyRequest read_study(const yaml::Node& node, const query::SymbolTable& names,
                        const diagram::Diagram& diagram, diagram::Loader& loader, const StudyWords& words,
                        yaml::Faults& faults);

/// Checks that parameter and signal of each carried value have the same unit and number of elements.
void check_carry(const StudyRequest& request, const plan::Plan& plan, yaml::Faults& faults);

/// Returns the parameters that each trial sets, whatever their value in the file.
std::vector<std::string> set_for_each_trial(const StudyRequest& request);

/// Returns the parameters whose values differ between trials: those, the circle's and the carried ones.
std::vector<std::string> varied_by_trials(const StudyRequest& request);

/// Checks the sweep. It may not vary what the study sets for each trial, except carried values. Recorded
/// trials have no sweep.
void check_sweep(const StudyRequest& request, const diagram::Diagram& diagram, yaml::Faults& faults);

/// Reads the file of recorded trials: those of the request's task, sorted. Adds faults for trials of unknown
/// conditions. Throws TableError and EnvironmentError.
void read_recorded(StudyRequest& request, yaml::Faults& faults);

}  // namespace stepwire::study
