#pragma once

#include <string>
#include <vector>

#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire {

inline const char* const counter = R"(stepwire: 1
title: A counter
outputs: {count: {signal: next, safe: -1}}
blocks:
  next: {block: Sum, u: [last, 1]}
  last: {block: UnitDelay, u: next}
)";

inline const char* const tank = R"(stepwire: 1
title: What flows in
inputs: {flow: {}}
outputs: {level: level, twice: twice}
blocks:
  level: {block: Integrator, u: flow, initial: 2}
  twice: {block: Gain, u: level, gain: 2}
)";

/// Two parts, a counter and a tank, and a diagram of these blocks.
struct Rig {
  DiagramFolder folder;

  Rig() {
    folder.write("counter.yaml", counter);
    folder.write("tank.yaml", tank);
  }
  table::Table run(const std::string& blocks, const std::string& record, const std::string& head = "") const {
    folder.write("all.yaml", text(blocks, record, head));
    return folder.run("all.yaml");
  }
  std::vector<std::string> faults(const std::string& blocks, const std::string& head = "") const {
    folder.write("all.yaml", text(blocks, "[on]", head));
    return folder.faults("all.yaml");
  }

  static std::string text(const std::string& blocks, const std::string& record, const std::string& head) {
    return "stepwire: 1\ntitle: all\nstep: 10 ms\nstop: 1 s\nsolver: rk4\n" + head + "blocks:\n" +
           "  on: {block: Pulse, period: 0.4 s, width: 50 %, delay: 0.1 s}\n" + blocks + "record: " + record +
           "\n";
  }
};

}  // namespace stepwire
