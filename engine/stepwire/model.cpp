#include "engine/stepwire/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/analyse/kept/kept_numbers.hpp"
#include "engine/analyse/kept/names.hpp"
#include "engine/base/text/count.hpp"
#include "engine/stepwire/content.hpp"

namespace stepwire {

namespace {

std::string unit_of(const std::optional<unit::Dimension>& dimension) {
  return dimension && *dimension != unit::Dimension{} ? unit::si_name(*dimension) : "";
}

std::vector<diagram::Setting> settings_of(const NamedTexts& texts) {
  std::vector<diagram::Setting> settings;
  for (const auto& [name, text] : texts) settings.push_back({name, text, name + "=" + text});
  return settings;
}

/// Returns the index of the element with this name. Throws Error without one.
template <class Info>
std::size_t find(const std::vector<Info>& all, const std::string& name, const char* kind,
                 const std::string& file) {
  const auto found = std::ranges::find(all, name, &Info::name);
  if (found != all.end()) return static_cast<std::size_t>(found - all.begin());
  std::vector<std::string> names;
  for (const Info& info : all) names.push_back(info.name);
  throw yaml::Error(
      yaml::Fault{{file, {}},
                  name,
                  fmt::format("there is no {} of this name", kind) + yaml::did_you_mean(name, names),
                  {}});
}

/// Job with its registry and loader.
struct Loaded {
  Loaded(const std::string& path, Registry blocks, const std::vector<diagram::Setting>& settings)
      : registry(std::move(blocks)), loader(registry), job(run::make_job(loader, path, settings)) {}

  Registry registry;
  diagram::Loader loader;
  run::Job job;
};

/// Returns the numbers that the sweep of a job keeps. Throws Error if one of them has a fault.
std::shared_ptr<const run::RunNumbers> kept_of(const run::Job& job) {
  query::SymbolTable names = kept::names_of(job);
  yaml::Faults faults;
  auto numbers = kept::read_kept_numbers(job.plan.diagram, names, faults);
  faults.throw_if_any();
  return numbers;
}

template <class Id>
std::size_t index_of(Id id, const Model::Content* model) {
  if (id.model != model) throw std::logic_error("a signal or input of another model is used");
  return id.index;
}

}  // namespace

Model::Content::Content(std::shared_ptr<const run::Job> of) : job(std::move(of)), kept(kept_of(*job)) {
  const plan::Plan& plan = job->plan;
  for (const auto& [name, signal] : diagram::named_signals(plan.diagram)) {
    slots.push_back(plan.slot(signal));
    signals.push_back({name, unit_of(plan.dimension(signal)), static_cast<std::size_t>(slots.back().size),
                       static_cast<std::size_t>(slots.back().columns)});
  }
  for (const diagram::DiagramInput& input : plan.diagram.inputs) {
    const diagram::SignalRef signal{input.block, 0, -1};
    const plan::SignalSlot slot = plan.slot(signal);
    inputs.push_back({input.name, unit_of(plan.dimension(signal)), static_cast<std::size_t>(slot.size),
                      input.doc, static_cast<std::size_t>(slot.columns)});
  }
}

std::size_t Model::Content::index(SignalId signal) const {
  return index_of(signal, this);
}

std::size_t Model::Content::index(InputId input) const {
  return index_of(input, this);
}

std::vector<plan::SignalSlot> Model::Content::slots_in(const plan::Plan& plan) const {
  const auto named = diagram::named_signals(plan.diagram);
  std::vector<plan::SignalSlot> found;
  for (const SignalInfo& signal : signals) {
    const auto known = named.find(signal.name);
    found.push_back(known == named.end() ? plan::SignalSlot{0, 0} : plan.slot(known->second));
  }
  return found;
}

void set_value(run::Executor& run, const std::string& name, yaml::Node value) {
  const diagram::Diagram& diagram = run.plan().diagram;
  const diagram::Assignment assignment{name, std::move(value), "set " + name};
  if (run.set(diagram::Variation(diagram, {name}), {&assignment, 1}) == run::Executor::Setting::done) return;
  throw yaml::Error(yaml::Fault{
      {diagram.file, {}},
      name,
      fmt::format("cannot be set in a run ({}); load the model with this value", run.structure_change()),
      {}});
}

void check_numbers(const InputInfo& input, std::span<const double> numbers) {
  const auto refuse = [&](const std::string& message) {
    throw yaml::Error(yaml::Fault{{}, input.name, message, {}});
  };
  if (numbers.size() != input.size)
    refuse(fmt::format("takes {}, not {}", text::counted(input.size, "number"), numbers.size()));
  const auto nan = std::ranges::find_if(numbers, [](double number) { return std::isnan(number); });
  if (nan == numbers.end()) return;
  refuse(numbers.size() == 1
             ? "takes a number, not nan"
             : fmt::format("takes numbers, and element {} is nan", nan - numbers.begin() + 1));
}

const std::string& Model::file() const {
  return content_->job->plan.diagram.file;
}

double Model::step() const {
  return content_->job->plan.diagram.step;
}

double Model::stop() const {
  return content_->job->plan.diagram.stop;
}

std::size_t Model::runs() const {
  return std::max<std::size_t>(content_->job->points.size(), 1);
}

const std::vector<SignalInfo>& Model::signals() const {
  return content_->signals;
}

SignalId Model::signal(const std::string& name) const {
  return {content_.get(), find(content_->signals, name, "signal", file())};
}

const std::vector<InputInfo>& Model::inputs() const {
  return content_->inputs;
}

InputId Model::input(const std::string& name) const {
  return {content_.get(), find(content_->inputs, name, "input", file())};
}

std::vector<ParameterInfo> Model::parameters() const {
  std::vector<ParameterInfo> all;
  for (const diagram::DiagramParameter& parameter : content_->job->plan.diagram.parameters)
    all.push_back({parameter.name, parameter.text, unit_of(parameter.dimension), parameter.doc});
  return all;
}

Model load(const std::string& path, Registry blocks, const NamedTexts& settings) {
  const auto loaded = std::make_shared<const Loaded>(path, std::move(blocks), settings_of(settings));
  return Model(std::make_shared<const Model::Content>(std::shared_ptr<const run::Job>(loaded, &loaded->job)));
}

}  // namespace stepwire
