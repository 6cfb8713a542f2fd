#pragma once

#include <vector>

#include "engine/analyse/estimation/sensitive_subdiagram.hpp"
#include "engine/simulate/run/observer.hpp"

namespace stepwire::estimation {

/// Records the signals that a part reads, in a run of the whole diagram.
class TapeWriter : public run::RunObserver {
 public:
  TapeWriter(const SensitiveSubdiagram& part, std::vector<double>& tape) : part_(part), tape_(tape) {}
  void evaluated(const run::ObservedRun& run) override { part_.append(run.simulation.values(), tape_); }

 private:
  const SensitiveSubdiagram& part_;
  std::vector<double>& tape_;
};

/// Replays these signals into a run of the part.
class TapePlayer : public run::RunObserver {
 public:
  TapePlayer(const SensitiveSubdiagram& part, const std::vector<double>& tape) : part_(part), tape_(tape) {}
  run::Flow before_tick(const run::ObservedRun& run) override {
    part_.play(tape_, run.simulation);
    return run::Flow::go_on;
  }

 private:
  const SensitiveSubdiagram& part_;
  const std::vector<double>& tape_;
};

}  // namespace stepwire::estimation
