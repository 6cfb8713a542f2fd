#include "engine/simulate/profile/call_times.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace stepwire::profile {

namespace {

constexpr double aim_of_table = 4e-6, aim_of_call = 4e-7;  // [s]; 200 and 20 clock readings

/// Returns the block at each offset of the memory of blocks.
std::map<std::size_t, std::size_t> blocks_by_memory(const plan::Plan& plan) {
  std::map<std::size_t, std::size_t> blocks;
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) blocks[plan.blocks[b].memory] = b;
  return blocks;
}

plan::KernelCall only(const plan::KernelCall& batch, std::size_t index, std::size_t bytes) {
  const std::size_t first = batch.first + index * bytes;
  return {batch.run, first, first + bytes, 1, batch.period};
}

double ratio(double part, double whole) {
  return whole > 0.0 ? part / whole : 0.0;
}

}  // namespace

CallTimes::CallTimes(const plan::Plan& plan, const std::vector<plan::KernelCall>& batches) : plan_(plan) {
  const auto blocks = blocks_by_memory(plan);
  for (const plan::KernelCall& batch : batches) {
    Call call{batch, {blocks.at(batch.first)}};
    const std::size_t bytes = plan.diagram.blocks[call.blocks.front()].type().bytes;
    for (std::size_t i = 1; i < batch.count; ++i) call.blocks.push_back(blocks.at(batch.first + i * bytes));
    call.alone.assign(batch.count, 0.0);
    calls_.push_back(std::move(call));
  }
}

void CallTimes::sample(run::Executor& simulation, const Stopwatch& stopwatch) {
  ++samples_;
  if (calls_.empty()) return;
  table_ += stopwatch.repeated(aim_of_table, [&] {
    for (const Call& call : calls_) simulation.call(call.batch);
  });
  for (Call& call : calls_) {
    call.seconds += stopwatch.repeated(aim_of_call, [&] { simulation.call(call.batch); });
    if (call.blocks.size() == 1) continue;
    const std::size_t bytes = plan_.diagram.blocks[call.blocks.front()].type().bytes;
    for (std::size_t i = 0; i < call.blocks.size(); ++i) {
      const plan::KernelCall one = only(call.batch, i, bytes);
      call.alone[i] += stopwatch.repeated(aim_of_call, [&] { simulation.call(one); });
    }
  }
}

void CallTimes::add_to(std::vector<BlockCost>& blocks, std::size_t phase, const CallCount& calls) const {
  double apart = 0.0;
  for (const Call& call : calls_) apart += call.seconds;
  for (const Call& call : calls_) {
    const std::int64_t count = calls(plan_.periods[static_cast<std::size_t>(call.batch.period)]);
    const double of_call =
        table_ * ratio(call.seconds, apart) / std::max(1, samples_) * static_cast<double>(count);
    const double alone = std::accumulate(call.alone.begin(), call.alone.end(), 0.0);
    for (std::size_t i = 0; i < call.blocks.size(); ++i) {
      const double share = call.blocks.size() == 1 ? 1.0 : ratio(call.alone[i], alone);
      blocks[call.blocks[i]].phases[phase] += {count, of_call * share};
    }
  }
}

}  // namespace stepwire::profile
