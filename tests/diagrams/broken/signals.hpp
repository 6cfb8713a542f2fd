#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/app/session/outcome.hpp"

namespace stepwire::broken {

/// A signal that a picture may draw.
struct Signal {
  std::string text;
  std::optional<unit::Dimension> dimension;
  std::optional<std::size_t> recording;  ///< none: any has it

  bool operator==(const Signal&) const = default;
};

/// The signals that the figures of a file draw, in their order, and behind them those that it records.
std::vector<Signal> signals_of(const session::LoadedModel& model, const session::Outcome& outcome);

/// Those of the list that could be drawn in the place of one, the next one in the list first.
std::vector<Signal> instead_of(const query::Formula& drawn, const std::vector<Signal>& signals);

/// Returns true for a key of rows that are drawn, false for one that selects or groups them.
bool is_drawn(const std::string& channel);

}  // namespace stepwire::broken
