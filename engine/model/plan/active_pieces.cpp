#include "engine/model/plan/active_pieces.hpp"

#include <algorithm>

#include "engine/model/plan/active.hpp"

namespace stepwire::plan {

namespace {

constexpr std::size_t shortest = 16;  // numbers that are processed as fast as one check of a guard

void append(std::vector<ActivePiece>& pieces, const ActivePiece& piece) {
  if (!pieces.empty() && pieces.back().active == piece.active)
    pieces.back().end = piece.end;
  else
    pieces.push_back(piece);
}

/// Returns for each number of the workspace the index of its guard output; -1 for always active ones.
std::vector<std::ptrdiff_t> active_places(const Plan& plan) {
  std::vector<std::ptrdiff_t> places(plan.layout.size, -1);
  for (std::size_t b = 0; b < plan.blocks.size(); ++b)
    for (const auto* slots : {&plan.blocks[b].outputs, &plan.blocks[b].states, &plan.blocks[b].derivatives})
      for (const SignalSlot& slot : *slots)
        std::fill_n(places.begin() + static_cast<std::ptrdiff_t>(slot.offset), slot.size, active_of(plan, b));
  return places;
}

}  // namespace

std::vector<ActivePiece> active_pieces(const Plan& plan, std::size_t first, std::size_t end) {
  if (plan.guards.empty()) return {{first, end, -1}};
  const std::vector<std::ptrdiff_t> places = active_places(plan);
  std::vector<ActivePiece> exact, pieces;
  for (std::size_t i = first; i < end; ++i) append(exact, {i, i + 1, places[i]});
  for (ActivePiece piece : exact) {
    if (piece.end - piece.first < shortest) piece.active = -1;
    append(pieces, piece);
  }
  return pieces;
}

}  // namespace stepwire::plan
