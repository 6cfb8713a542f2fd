#pragma once

#include <iterator>
#include <utility>
#include <vector>

#include "engine/base/expression/program.hpp"

namespace stepwire::expression {

/// Removes the last `count` pieces and returns them.
template <class Piece>
std::vector<Piece> take_last(std::vector<Piece>& pieces, int count) {
  const auto first = pieces.end() - count;
  std::vector<Piece> taken(std::make_move_iterator(first), std::make_move_iterator(pieces.end()));
  pieces.erase(first, pieces.end());
  return taken;
}

/// Folds an expression bottom-up into one piece. `make` maps variables, numbers, choices of three pieces, and
/// operations on pieces to pieces. Operations are passed with their position in the text.
template <class Piece, class Make>
Piece fold(const Program& program, const Make& make) {
  std::vector<Piece> pieces;
  for (const Instruction& instruction : program.code) {
    const std::vector<Piece> of = take_last(pieces, instruction.count);
    if (instruction.kind == Instruction::Kind::variable) pieces.push_back(make.variable(instruction.index));
    if (instruction.kind == Instruction::Kind::number)
      pieces.push_back(make.number(program.numbers[instruction.index]));
    if (instruction.operation)
      pieces.push_back(make.operation(*instruction.operation, of, instruction.index));
    if (instruction.kind == Instruction::Kind::choice) pieces.push_back(make.choice(of[0], of[1], of[2]));
  }
  return std::move(pieces.back());
}

}  // namespace stepwire::expression
