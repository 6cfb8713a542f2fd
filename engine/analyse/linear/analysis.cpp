#include "engine/analyse/linear/analysis.hpp"

#include <cmath>

#include "engine/analyse/linear/gain_at_rest.hpp"

namespace stepwire::linear {

namespace {

ChannelAnalysis channel_of(const Linearization& all, std::size_t input, std::size_t output) {
  const StateSpace whole = all.system.channel(input, output), channel = whole.connected();
  ChannelAnalysis found{channel.inputs[0].name, channel.outputs[0].name, zeros_of(channel),
                        gain_at_rest(channel),  bandwidth(channel),      margins_of(whole, all.feedback)};
  if (std::isnan(found.gain_at_rest))
    found.margins.notes.emplace_back(
        "the gain at rest and the bandwidth: rounding hides whether slow poles are at rest");
  return found;
}

}  // namespace

Analysis analyse(Linearization linearization, std::optional<double> feedback) {
  Analysis analysis;
  static_cast<Linearization&>(analysis) = std::move(linearization);
  if (feedback) analysis.feedback = *feedback;
  const StateSpace& system = analysis.system;
  analysis.modes = modes_of(system);
  analysis.zeros = zeros_of(system.connected());
  analysis.stability = stability_of(system);
  if (analysis.stability.stable && system.delays.empty() && !is_stable(system))
    analysis.notes.emplace_back(
        "a pole at rest is not on the way from inputs to outputs, and does not count for stability");
  analysis.controllable = controllability(system);
  analysis.observable = observability(system);
  for (std::size_t i = 0; i < system.inputs.size(); ++i)
    for (std::size_t o = 0; o < system.outputs.size(); ++o)
      analysis.channels.push_back(channel_of(analysis, i, o));
  return analysis;
}

}  // namespace stepwire::linear
