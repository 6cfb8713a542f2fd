#include "blocks/cosimulation/fmu.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>

#include "engine/base/fmi/assignments.hpp"
#include "engine/base/fmi/unit_error.hpp"
#include "engine/base/math/instant.hpp"
#include "engine/model/block/configure.hpp"
#include "engine/model/block/declare.hpp"
#include "engine/model/block/value.hpp"

namespace stepwire {

namespace {

/// Returns the texts of a value of the map, one number or a list.
std::vector<std::string> texts_of(const Value& value, const Configure& is) {
  std::vector<std::string> texts;
  if (value.text()) texts.push_back(*value.text());
  if (value.list())
    for (const Value& item : *value.list()) {
      if (!item.text()) is.refuse<&Fmu::parameters>("a value is a number or a list of numbers", item);
      texts.push_back(*item.text());
    }
  if (texts.empty()) is.refuse<&Fmu::parameters>("a value is a number or a list of numbers", value);
  return texts;
}

std::vector<fmi::Assignment> assignments_of(const Fmu& block, const fmi::Description& description,
                                            const Configure& is) {
  std::vector<fmi::Assignment> assignments;
  const Value tree = block.parameters.value();
  if (!tree.map() && tree.line > 0)
    is.refuse<&Fmu::parameters>("must be a map of names and values: {k: 2 1/s}", tree);
  if (!tree.map()) return assignments;
  for (const auto& [name, value] : *tree.map()) {
    auto read = fmi::read_assignment(description, name, texts_of(value, is));
    if (!read.wrong.empty()) is.refuse<&Fmu::parameters>(read.wrong.text(), value);
    assignments.push_back(std::move(read.assignment));
  }
  return assignments;
}

/// Reads the values of `parameters` and tries the unit with them. Faults are refused with their line.
void configure_unit(Fmu& block, Configure& is, fmi::Mode mode) {
  try {
    fmi::Setup setup{fmi::open_package(block.file.string()), mode, is.name().empty() ? "unit" : is.name()};
    setup.assignments = assignments_of(block, setup.package->description(), is);
    if (setup.package->description().smooth) is.smooth();
    block.unit.prepare(std::move(setup), block.isolate);
  } catch (const fmi::UnitError& error) {
    is.refuse<&Fmu::file>(error.what());
  }
  is.size("k", static_cast<Index>(std::max<std::size_t>(block.unit.kept(), 1)));
}

}  // namespace

void Fmu::begin() {
  unit.start(t);
  unit_moves = static_cast<double>(unit.moves);
  unit_state = 0.0;
  keep();
}

void Fmu::keep() {
  if (!unit.works() || unit.kept() == 0) return;
  std::memcpy(unit_state.data(), unit.exchange().kept(), unit.kept() * sizeof(double));
  std::memcpy(unit.last_kept.data(), unit.exchange().kept(), unit.kept() * sizeof(double));
}

void Fmu::hand_over() {
  double* numbers = unit.exchange().inputs();
  const auto& sizes = unit.input_sizes();
  for (std::size_t i = 0; i < sizes.size(); numbers += sizes[i++])
    if (inputs[i].connected()) std::copy_n(inputs[i].data(), sizes[i], numbers);
}

void Fmu::show(const double* numbers) {
  for (std::size_t i = 0; i < unit.output_count(); numbers += results[i++].size())
    std::copy_n(numbers, results[i].size(), results[i].data());
}

bool Fmu::follow() {
  if (!unit.works()) return false;
  // Compared as bytes, which are no numbers.
  const bool same = static_cast<double>(unit.moves) == unit_moves &&
                    std::memcmp(unit.last_kept.data(), unit_state.data(), unit.kept() * sizeof(double)) == 0;
  if (same) return false;
  if (unit_moves == 0.0) {  // a guard has reset it to 0
    unit.refuse("its condition has reset it, and a unit starts but once; give `enable` states: hold");
    return false;
  }
  if (unit.kept() == 0) {
    unit.refuse("the run was put back to an earlier moment, and the unit cannot save and restore its state");
    return false;
  }
  std::memcpy(unit.exchange().kept(), unit_state.data(), unit.kept() * sizeof(double));
  unit.run(fmi::Operation::load);
  std::memcpy(unit.last_kept.data(), unit_state.data(), unit.kept() * sizeof(double));
  unit.moves = static_cast<long>(unit_moves);
  return true;
}

void Fmu::settle() {
  if (unit.works()) {
    unit_moves = static_cast<double>(++unit.moves);
    keep();
  }
  if (!unit.works()) unit_failed.raise(t);
}

void SteppedFmu::start() {
  begin();
  if (unit.works()) std::copy_n(unit.exchange().outputs(), unit.numbers_shown(), unit_outputs.data());
}

// A unit that requests the end of the run in a whole step ends it at the tick that the step reaches.
void SteppedFmu::outputs() {
  follow();
  show(unit_outputs.data());
  if (has_ended()) unit_over.raise(t);
}

void SteppedFmu::update() {
  follow();
  if (unit.works() && !has_ended()) {
    hand_over();
    unit.exchange().time = t;
    unit.exchange().length = period;
    if (unit.run(fmi::Operation::step))
      std::copy_n(unit.exchange().outputs(), unit.numbers_shown(), unit_outputs.data());
    if (unit.works()) judge_reached();
  }
  settle();
}

/// Ends the run at the time that a unit has reached that ends within its step. Reports one that has passed
/// the end of its step.
void SteppedFmu::judge_reached() {
  const fmi::Exchange& exchange = unit.exchange();
  const double end = t + exchange.length, rounding = 1e-9 * std::max(exchange.length, end);
  if (exchange.reached > end + rounding) beyond_step.raise(t);
  if (!has_ended()) return;
  if (exchange.ended == 2)
    unit_over.raise(t);
  else if (exchange.reached < end - 1e-9 * exchange.length)
    unit_over.raise(std::max<double>(t, exchange.reached));
}

void ContinuousFmu::start() {
  begin();
  if (!unit.works()) return;
  std::copy_n(unit.exchange().states(), unit_states.size(), unit_states.data());
  unit_event = unit.exchange().next;
  unit.acted_at = -1.0;
  unit.acted_on.assign(std::accumulate(unit.input_sizes().begin(), unit.input_sizes().end(), std::size_t{0}),
                       0.0);
}

bool ContinuousFmu::at_present(fmi::Operation operation) const {
  auto& self = const_cast<ContinuousFmu&>(*this);
  if (!self.unit.works() || has_ended()) return false;
  self.hand_over();
  fmi::Exchange& exchange = unit.exchange();
  const bool acts = operation == fmi::Operation::act && reached(t, unit_event);
  exchange.time = acts ? std::max<double>(t, unit_event) : t;  // of two roundings of one time the later one
  std::copy_n(unit.early_at == t ? unit.early_states.data() : unit_states.data(), unit_states.size(),
              exchange.states());
  return self.unit.run(operation);
}

// An event of time at a tick belongs to the tick: its row has the outputs after it.
void ContinuousFmu::outputs_at_instant() {
  if (follow()) unit.early_at = -1.0;
  if (unit.early_at != t && reached(t, unit_event)) act_early();
  outputs();
}

/// Handles an event before the outputs are computed. update() stores the states.
void ContinuousFmu::act_early() {
  if (!at_present(fmi::Operation::act)) return;
  unit.early_states.assign(unit.exchange().states(), unit.exchange().states() + unit_states.size());
  unit.early_at = t;
}

void ContinuousFmu::outputs() {
  follow();
  if (at_present(fmi::Operation::outputs) || has_ended()) show(unit.exchange().outputs());
  if (!unit.works()) unit_failed.raise(t);
}

void ContinuousFmu::derivatives() {
  if (at_present(fmi::Operation::slopes))
    std::copy_n(unit.exchange().slopes(), unit_states.size(), unit_states.derivative.data());
  else
    unit_states.derivative = 0.0;
}

void ContinuousFmu::update() {
  follow();
  if (at_present(fmi::Operation::act)) {
    if (unit.exchange().changed || unit.early_at == t)
      std::copy_n(unit.exchange().states(), unit_states.size(), unit_states.data());
    unit_event = unit.exchange().next;
  }
  unit.early_at = -1.0;
  if (has_ended()) unit_over.raise(t);
  settle();
}

/// Acts once for the inputs of an instant.
void ContinuousFmu::update_at_event() {
  const bool ended_before = has_ended() && unit.early_at != t;
  if (!unit.works() || ended_before) return;
  hand_over();
  const double* const inputs = unit.exchange().inputs();
  if (unit.acted_at == t && std::equal(unit.acted_on.begin(), unit.acted_on.end(), inputs)) return;
  unit.acted_at = t;
  std::copy_n(inputs, unit.acted_on.size(), unit.acted_on.begin());
  update();
}

void ContinuousFmu::crossings(Crossings& zero) const {
  const bool known = at_present(fmi::Operation::crossings);
  const std::size_t count = unit.indicator_count();
  for (std::size_t i = 0; i < count; ++i) zero.add(known ? unit.exchange().indicators()[i] : 1.0);
}

std::string ContinuousFmu::reason() const {
  if (reached(unit_event, t)) return Fmu::reason();
  return fmt::format("{}; its event at {:g} s lies between two ticks, where only `events: locate` stops",
                     Fmu::reason(), static_cast<double>(unit_event));
}

double ContinuousFmu::next_edge() const {
  const double next = unit_event;
  return next > t ? next : std::numeric_limits<double>::infinity();
}

void SteppedFmu::configure(Configure& is) {
  configure_unit(*this, is, fmi::Mode::co_simulation);
}

void ContinuousFmu::configure(Configure& is) {
  configure_unit(*this, is, fmi::Mode::model_exchange);
}

}  // namespace stepwire
