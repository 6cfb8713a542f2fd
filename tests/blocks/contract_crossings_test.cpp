// What a block that declares crossings must do: as many numbers as it says, and a change of sign wherever its
// outputs begin to do something else.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "engine/simulate/solve/event_locator.hpp"
#include "tests/blocks/contract_rig.hpp"

using namespace stepwire;

namespace {

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
      else
        type_.inputs[i].bind(block, at(planned_.inputs[i].front()), planned_.inputs[i].front().size);
    for (std::size_t o = 0; o < type_.outputs.size(); ++o)
      type_.outputs[o].bind(block, at(planned_.outputs[o]), planned_.outputs[o].size);
    for (std::size_t s = 0; s < type_.states.size(); ++s)
      type_.states[s].bind(block, at(planned_.states[s]), at(planned_.derivatives[s]),
                           planned_.states[s].size);
  }

  std::vector<double> crossings(std::size_t count) const {
    std::vector<double> numbers(count + 4, std::numeric_limits<double>::quiet_NaN());
    type_.run_crossings(block_.get(), numbers.data());
    return numbers;
  }
  void outputs() { run(type_.run_outputs); }
  void update() { run(type_.run_update); }
  double output() const { return values_[planned_.outputs.front().offset]; }
  double& input(std::size_t i) { return values_[planned_.inputs[i].front().offset]; }
  bool has(std::size_t input) const { return !planned_.inputs[input].empty(); }

 private:
  double* at(const plan::SignalSlot& slot) { return values_.data() + slot.offset; }
  void run(const Kernels& kernels) {
    auto* first = static_cast<std::byte*>(block_.get());
    if (kernels) kernels[Specialization::nothing](first, first + type_.bytes);
  }

  const BlockType& type_;
  const plan::PlannedBlock& planned_;
  AnyBlock block_;
  std::vector<double> values_;
};

/// Does one of the crossings read this input?
bool is_read(const BlockType& type, const std::string& input) {
  return std::ranges::any_of(type.crossings, [&](const CrossingSpec& crossing) {
    return std::ranges::find(crossing.inputs, input) != crossing.inputs.end();
  });
}

template <class Check>
void for_every_crossing_block(const Check& check) {
  for (const BlockType* type : library().types()) {
    if (type->crossings.empty()) continue;
    for (const Wiring& wiring : wirings_of(*type)) {
      INFO(wiring.text);
      const auto plan = plan_of({"events: locate\n" + wiring.text, wiring.may_be_refused});
      if (!plan) continue;
      const std::size_t tested = tested_in(*plan);
      for (const plan::CrossingCall& call : plan->crossings)
        if (call.block == tested) check(*plan, tested, call.count);
    }
  }
}

}  // namespace

TEST_CASE("a block adds as many crossings as its declaration has rows and its signals elements") {
  std::size_t blocks = 0;
  for_every_crossing_block([&](const plan::Plan& plan, std::size_t tested, std::size_t count) {
    ++blocks;
    const std::vector<double> numbers = Bench(plan, tested).crossings(count);
    for (std::size_t i = 0; i < numbers.size(); ++i) CHECK(std::isnan(numbers[i]) == (i >= count));
  });
  CHECK(blocks > 10);
}

TEST_CASE("where an output jumps or has a bend a crossing has changed its sign") {
  std::size_t bends = 0;
  for_every_crossing_block([&](const plan::Plan& plan, std::size_t tested, std::size_t count) {
    const BlockType& type = plan.diagram.blocks[tested].type();
    if (type.has_continuous_state()) return;  // its output is the solver's
    for (std::size_t i = 0; i < type.inputs.size(); ++i) {
      Bench bench(plan, tested);
      if (!bench.has(i) || !is_read(type, type.inputs[i].name)) continue;
      INFO(type.name << "." << type.inputs[i].name);
      std::vector<double> before = bench.crossings(count);
      double last[2]{};
      int since = 0;  // a change of sign
      for (int k = 0; k < 8000; ++k) {
        bench.input(i) = 3.0 * std::sin(0.00231 * k) + 0.01234;
        since = solve::sign_changes(before.data(), bench.crossings(count).data(), count) ? 0 : since + 1;
        bench.outputs();
        const double y = bench.output(), bend = y - 2.0 * last[0] + last[1];
        if (k > 2 && std::abs(bend) > 1e-3) {
          ++bends;
          CHECK(since <= 2);  // as many steps as the bend is taken of
        }
        last[1] = last[0];
        last[0] = y;
        bench.update();
        before = bench.crossings(count);
      }
    }
  });
  CHECK(bends > 20);
}
