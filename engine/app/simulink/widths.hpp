#pragma once

#include <map>
#include <string>
#include <utility>

#include "engine/app/simulink/flat_model.hpp"

namespace stepwire::simulink {

/// The numbers of elements of signals, as far as they follow from the blocks before them.
class Widths {
 public:
  explicit Widths(FlatModel& model) : model_(model) {}

  /// Returns the number of elements of a source; 0 if unknown.
  std::size_t of(const std::string& source, int depth = 0);

 private:
  std::size_t of_block(const FlatBlock& flat, int port, int depth);
  std::size_t of_parameter(const FlatBlock& flat, const char* name);
  std::size_t of_inputs(const FlatBlock& flat, bool adds, int depth);

  FlatModel& model_;
  std::map<std::pair<std::size_t, int>, std::size_t> known_;
};

}  // namespace stepwire::simulink
