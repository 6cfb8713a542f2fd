#pragma once

#include <limits>
#include <vector>

#include "engine/model/plan/plan.hpp"

namespace stepwire {

/// A block of a plan on numbers of its own, which a test may set.
class Bench {
 public:
  Bench(const plan::Plan& plan, std::size_t index)
      : type_(plan.diagram.blocks[index].type()),
        planned_(plan.blocks[index]),
        block_(plan.diagram.blocks[index].block),
        values_(plan.layout.size, 0.5) {
    void* block = block_.get();
    for (std::size_t i = 0; i < type_.inputs.size(); ++i)
      if (planned_.inputs[i].empty())
        type_.inputs[i].unbind(block);
      else if (type_.inputs[i].bind_list)
        bind_list(i);
      else
        type_.inputs[i].bind(block, at(planned_.inputs[i].front()), planned_.inputs[i].front().size);
    for (std::size_t o = 0; o < type_.outputs.size(); ++o)
      type_.outputs[o].bind(block, at(planned_.outputs[o]), planned_.outputs[o].size);
    for (std::size_t s = 0; s < type_.states.size(); ++s)
      type_.states[s].bind(block, at(planned_.states[s]), at(planned_.derivatives[s]),
                           planned_.states[s].size);
    for (std::size_t n = 0; n < type_.diagnostics.size(); ++n)
      type_.diagnostics[n].bind(block, at(planned_.diagnostics[n]));
    for (const ClockSpec& clock : type_.clocks)
      if (clock.bind_time) clock.bind_time(block, values_.data() + plan::Layout::time);
  }

  std::vector<double> crossings(std::size_t count) const {
    std::vector<double> numbers(count + 4, std::numeric_limits<double>::quiet_NaN());
    type_.run_crossings(block_.get(), numbers.data());
    return numbers;
  }
  double next_edge() const { return type_.run_next_edge(block_.get()); }
  void outputs() { run(type_.run_outputs); }
  void outputs_at_instant() {
    run(type_.run_outputs_at_instant ? type_.run_outputs_at_instant : type_.run_outputs);
  }
  void update() { run(type_.run_update); }
  double& time() { return values_[plan::Layout::time]; }
  /// The numbers of all outputs.
  std::vector<double> all_outputs() const {
    std::vector<double> numbers;
    for (const plan::SignalSlot& slot : planned_.outputs)
      for (Eigen::Index k = 0; k < slot.size; ++k)
        numbers.push_back(values_[slot.offset + static_cast<std::size_t>(k)]);
    return numbers;
  }
  /// Of a state with one element.
  double& state(const char* name) {
    return values_[planned_.states[static_cast<std::size_t>(type_.state(name))].offset];
  }
  double output() const { return values_[planned_.outputs.front().offset]; }
  double& input(std::size_t i) { return values_[planned_.inputs[i].front().offset]; }
  bool has(std::size_t input) const { return !planned_.inputs[input].empty(); }

 private:
  void bind_list(std::size_t input) {
    std::vector<Inputs::Element>& elements = lists_.emplace_back();
    for (const plan::SignalSlot& slot : planned_.inputs[input]) elements.emplace_back(at(slot), slot.size);
    type_.inputs[input].bind_list(block_.get(), elements.data(), static_cast<Index>(elements.size()));
  }
  double* at(const plan::SignalSlot& slot) { return values_.data() + slot.offset; }
  void run(const Kernels& kernels) {
    auto* first = static_cast<std::byte*>(block_.get());
    if (kernels) kernels[Specialization::nothing](first, first + type_.bytes);
  }

  const BlockType& type_;
  const plan::PlannedBlock& planned_;
  AnyBlock block_;
  std::vector<double> values_;
  std::vector<std::vector<Inputs::Element>> lists_{};
};

}  // namespace stepwire
