#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "engine/simulate/run/executor.hpp"
#include "engine/stepwire/model.hpp"

namespace stepwire {

/// Numbers for inputs, stored until the tick from which on they apply.
class WaitingInputs {
 public:
  explicit WaitingInputs(const std::vector<InputInfo>& inputs) {
    for (const InputInfo& input : inputs) waiting_.push_back({std::vector<double>(input.size), false});
  }
  void put(std::size_t input, std::span<const double> values) {
    std::ranges::copy(values, waiting_[input].values.begin());
    waiting_[input].fresh = true;
  }
  void write_to(run::Executor& run) {
    for (std::size_t i = 0; i < waiting_.size(); ++i)
      if (std::exchange(waiting_[i].fresh, false)) run.write_input(i, waiting_[i].values.data());
  }
  void drop() {
    for (Waiting& input : waiting_) input.fresh = false;
  }

 private:
  struct Waiting {
    std::vector<double> values;
    bool fresh;
  };
  std::vector<Waiting> waiting_;
};

}  // namespace stepwire
