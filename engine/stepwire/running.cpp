#include <algorithm>
#include <stdexcept>

#include "engine/stepwire/content.hpp"
#include "engine/stepwire/moment.hpp"
#include "engine/stepwire/observer.hpp"

namespace stepwire {

std::int64_t Running::tick() const {
  return view_.run.tick();
}

double Running::time() const {
  return view_.run.time();
}

std::span<const double> Running::operator[](SignalId signal) const {
  const plan::SignalSlot& slot = view_.slots[view_.model.index(signal)];
  return {view_.run.values() + slot.offset, static_cast<std::size_t>(slot.size)};
}

void Running::set(const std::string& name, double value) {
  set_value(view_.run, name, diagram::value_of_number(value, {}));
}

void Running::set(const std::string& name, const std::string& text) {
  set_value(view_.run, name, diagram::value_of_text(text, "set " + name));
}

void Running::set(InputId input, double value) {
  set(input, std::span(&value, 1));
}

void Running::set(InputId input, std::span<const double> values) {
  const std::size_t index = view_.model.index(input);
  check_numbers(view_.model.inputs[index], values);
  view_.run.write_input(index, values.data());
}

Snapshot Running::snapshot() const {
  return Snapshot(std::make_shared<const Snapshot::Content>(
      Snapshot::Content{&view_.run.plan(), view_.run.workspace(), view_.run.workspace().values,
                        std::max<std::int64_t>(view_.run.tick() - 1, 0), false}));
}

void Running::restore(const Snapshot& snapshot) {
  check_plan(snapshot, view_.run.plan());
  view_.run.restore(snapshot.content().workspace);
}

}  // namespace stepwire
