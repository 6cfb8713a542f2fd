#include "engine/app/studio/live/loaded_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/analyse/query/series.hpp"

namespace stepwire::live {

namespace {

constexpr std::size_t most_formulas = 256;  // each is computed and stored at every tick

LiveColumn column_of(const query::Series& series) {
  LiveColumn column{series.label, series.formula.dimension, series.unit_text};
  column.scale = series.unit.from_si(1.0) - series.unit.from_si(0.0);
  column.offset = series.unit.from_si(0.0);
  column.formula = series.formula;
  return column;
}

}  // namespace

LoadedRun::LoadedRun(Loading loading, const MakeRun& make)
    : model_(std::move(loading.model)),
      again_(std::move(loading.again)),
      documents_(std::move(loading.documents)),
      signals_(plan()),
      names_(signals_.names(plan())),
      thread_(make(plan(), signals_)) {}

const yaml::Document* LoadedRun::document(const std::string& path) const try {
  return documents_ ? &documents_(path) : nullptr;
} catch (const yaml::Error&) {
  return nullptr;
}

std::shared_ptr<const session::LoadedModel> LoadedRun::model_with(const std::vector<LiveEvent>& set) {
  std::map<std::string, std::string> values;
  for (const LiveEvent& event : set)
    if (!event.is_input()) values[event.name] = event.text;
  const std::lock_guard lock(again_mutex_);
  if (!again_ || values.empty()) return {std::shared_ptr<void>(), &model_};
  if (again_model_ && again_values_ == values) return again_model_;
  session::LoadOptions options = model_.options;
  for (const auto& [name, value] : values) options.settings.push_back({name, value});
  again_model_ = std::make_shared<const session::LoadedModel>(again_(options));
  again_values_ = std::move(values);
  return again_model_;
}

std::size_t LoadedRun::find(const std::string& expression) {
  if (const auto signal = signals_.find(expression)) return *signal;
  const std::lock_guard lock(mutex_);
  if (const auto known = known_.find(expression); known != known_.end()) return known->second;
  if (formulas_.size() >= most_formulas)
    throw std::runtime_error(fmt::format("a run has at most {} expressions; load it again", most_formulas));
  yaml::Node node;
  node.kind = yaml::Node::Kind::scalar;
  node.text = expression;
  yaml::Faults faults;
  const auto series = query::read_series(node, names_, "signal", faults);
  faults.throw_if_any();
  if (!series) throw std::runtime_error("this is no expression");
  formulas_.push_back(column_of(*series));
  const std::size_t index = signals_.all().size() + formulas_.size() - 1;
  known_.emplace(expression, index);
  return index;
}

LiveColumn LoadedRun::column(std::size_t index) const {
  const auto& signals = signals_.all();
  if (index < signals.size()) {
    const LiveSignal& signal = signals[index];
    return {signal.name, signal.dimension, unit_text(signal.dimension)};
  }
  const std::lock_guard lock(mutex_);
  if (index - signals.size() < formulas_.size()) return formulas_[index - signals.size()];
  throw std::runtime_error(fmt::format("there is no column {}", index));
}

std::size_t LoadedRun::stored(std::size_t index) {
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = stored_.find(index); known != stored_.end()) return known->second;
  }
  const LiveColumn wanted = column(index);
  const std::size_t stored = wanted.formula ? thread_->stored(*wanted.formula) : thread_->stored(index);
  const std::lock_guard lock(mutex_);
  stored_.emplace(index, stored);
  return stored;
}

std::vector<std::size_t> LoadedRun::stored(const std::vector<std::size_t>& columns) {
  std::vector<std::size_t> all;
  for (const std::size_t column : columns) all.push_back(stored(column));
  return all;
}

std::int64_t LoadedRun::tick_at(double time) const {
  const double ticks = std::ceil(time / plan().diagram.step - 1e-6);
  return static_cast<std::int64_t>(std::clamp(ticks, 0.0, static_cast<double>(store().end_tick())));
}

}  // namespace stepwire::live
