#include "engine/model/plan/active_pieces.hpp"

#include <catch2/catch.hpp>

#include "tests/support/plan_text.hpp"

namespace stepwire::plan {

namespace {

std::string lags(int count, const std::string& enable) {
  std::string text = "step: 1 ms\nsolver: rk4\nblocks:\n  gate: {block: Pulse, period: 1 s}\n";
  for (int i = 0; i < count; ++i)
    text += "  x" + std::to_string(i) + ": {block: Lag, tau: 1 s, u: gate" + enable + "}\n";
  return text + "  y: {block: Lag, tau: 1 s, u: gate}\nrecord: [y]\n";
}

}  // namespace

TEST_CASE("numbers that stand still while something is off are pieces of their own") {
  const Plan plan = plan_text(lags(1, ", enable: gate"));
  CHECK(active_pieces(plan, plan.layout.states, plan.layout.derivatives).size() == 1);  // too few to split
  DiagramFolder folder;
  std::string part = "stepwire: 1\ntitle: part\ninputs: {u: {}}\noutputs: {y: x0}\nblocks:\n";
  for (int i = 0; i < 40; ++i) part += "  x" + std::to_string(i) + ": {block: Lag, tau: 1 s, u: u}\n";
  folder.write("part.yaml", part);
  folder.write("all.yaml",
               "stepwire: 1\ntitle: all\nstep: 1 ms\nstop: 1 s\nsolver: rk4\nblocks:\n"
               "  gate: {block: Pulse, period: 1 s}\n  off: {diagram: part.yaml, u: gate, enable: gate}\n"
               "  y: {block: Lag, tau: 1 s, u: gate}\nrecord: [y]\n");
  const Plan guarded = folder.plan("all.yaml");
  std::size_t in_guard = 0, all = 0;
  for (const ActivePiece& piece : active_pieces(guarded, guarded.layout.states, guarded.layout.derivatives)) {
    all += piece.end - piece.first;
    if (piece.active >= 0) in_guard += piece.end - piece.first;
    if (piece.active >= 0) CHECK(static_cast<std::size_t>(piece.active) == guarded.guards.front().active);
  }
  CHECK(all == guarded.layout.state_count);
  CHECK(in_guard == 40);
}

TEST_CASE("without conditions there is one piece") {
  const Plan plan = plan_text(lags(30, ""));
  CHECK(active_pieces(plan, plan.layout.states, plan.layout.derivatives).size() == 1);
}

}  // namespace stepwire::plan
