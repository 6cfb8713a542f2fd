#include "blocks/records/preparation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "blocks/records/steps.hpp"

namespace stepwire {

namespace {

/// Kind of step, identified by its first key.
struct PreparationStep {
  std::vector<std::string> keys;
  std::string example, doc;
  void (*apply)(Record& record, const StepOptions& given);
};

const std::vector<PreparationStep>& all_steps() {
  static const std::vector<PreparationStep> all{
      {{"resample", "method"},
       "{resample: 1 ms, method: linear}",
       "evenly spaced rows, by straight lines or band_limited",
       resample},
      {{"remove"},
       "{remove: mean}",
       "takes off the mean, the first row (`first`) or a value (`52.8 N`)",
       remove_offset},
      {{"trim", "threshold", "margin"},
       "{trim: x, threshold: 2 %, margin: 0 s}",
       "keeps the rows from the first to the last movement of a column of the file, told by a share of its "
       "range, "
       "and `margin` more at either end, less where negative",
       trim},
      {{"low_pass", "order"},
       "{low_pass: 40 Hz, order: 4}",
       "zero-phase Butterworth filter, run forward and backward as filtfilt of scipy and MATLAB: half the "
       "amplitude "
       "(-6 dB) at this frequency",
       low_pass},
      {{"differentiate"},
       "{differentiate: 1}",
       "first or second derivative over time by central differences",
       differentiate}};
  return all;
}

std::string examples() {
  std::string text;
  for (const PreparationStep& step : all_steps()) text += (text.empty() ? "" : ", ") + step.example;
  return text;
}

void run_step(Record& record, const Value& tree, const StepOptions::Refuse& refuse) {
  const auto is_it = [&](const PreparationStep& step) { return tree.find(step.keys.front()) != nullptr; };
  const auto step = std::find_if(all_steps().begin(), all_steps().end(), is_it);
  if (step == all_steps().end()) return refuse("no such step; it is one of " + examples(), tree);
  for (const auto& [key, value] : *tree.map())
    if (std::find(step->keys.begin(), step->keys.end(), key) == step->keys.end())
      refuse(fmt::format("{} has no '{}'; it is {}", step->keys.front(), key, step->example), value);
  const StepOptions given(tree, step->keys.front(), step->example, refuse);
  step->apply(record, given);
  for (const RecordColumn& column : record.columns)
    if (!std::all_of(column.values.begin(), column.values.end(), [](double y) { return std::isfinite(y); }))
      given.refuse(fmt::format("{} of {} gets larger than numbers can be", column.name, record.file));
}

}  // namespace

void prepare_record(Record& record, const Value& steps, const StepOptions::Refuse& refuse) {
  if (steps.map() && steps.map()->empty()) return;
  if (!steps.list())
    return refuse("must be a list of steps, as [" + all_steps().front().example + "]", steps);
  for (const Value& step : *steps.list()) run_step(record, step, refuse);
}

std::string preparation_help() {
  std::string text;
  for (const PreparationStep& step : all_steps())
    text += fmt::format("{}{}, {}", text.empty() ? "" : "; ", step.example, step.doc);
  return text;
}

}  // namespace stepwire
