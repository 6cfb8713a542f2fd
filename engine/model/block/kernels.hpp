#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace stepwire {

/// Runs one phase of the blocks of one type, at least one, that lie one behind the other in memory up to
/// `end`.
using Kernel = void (*)(void* first, void* end);

/// What a kernel may take for granted of its blocks. The more is known, the less has to be asked at every
/// step.
enum class Known {
  nothing,
  one_element,    ///< every port and state has one
  two_in_list,    ///< as well, and the list of inputs `u` has two
  three_in_list,  ///< or three
  plain_slope,    ///< one element, and the slope is but the input: `slope_is_input` of the block is true
  count
};

/// The kernels of one phase, by what they take for granted.
class Kernels {
 public:
  /// Null where the type has no such phase, or nothing of which that could be known.
  Kernel operator[](Known known) const { return kernels_[static_cast<std::size_t>(known)]; }
  Kernel& operator[](Known known) { return kernels_[static_cast<std::size_t>(known)]; }
  explicit operator bool() const { return (*this)[Known::nothing] != nullptr; }
  bool contains(Kernel kernel) const {
    return std::find(kernels_.begin(), kernels_.end(), kernel) != kernels_.end();
  }

 private:
  std::array<Kernel, static_cast<std::size_t>(Known::count)> kernels_{};
};

namespace detail {

template <class Port>
[[gnu::always_inline]] inline void assume_one_element(const Port& port) {
  if constexpr (requires { port.size(); })
    if (port.size() != 1) __builtin_unreachable();
}

/// Tells the compiler what is known. The ports and the state that most blocks have, with the names that they
/// have by custom, are enough: sizes are asked of what is written.
template <Known known, class Block>
[[gnu::always_inline]] inline void assume(const Block& block) {
  if constexpr (known == Known::nothing) return;
  if constexpr (requires { block.u.size(); }) assume_one_element(block.u);
  if constexpr (requires { block.y.size(); }) assume_one_element(block.y);
  if constexpr (requires { block.x.dot.size(); }) assume_one_element(block.x.dot);
  if constexpr (known == Known::two_in_list)
    if (block.u.count() != 2) __builtin_unreachable();
  if constexpr (known == Known::three_in_list)
    if (block.u.count() != 3) __builtin_unreachable();
  if constexpr (known == Known::plain_slope)
    if (!block.slope_is_input) __builtin_unreachable();
}

template <class Block, void (Block::*phase)(), Known known>
void run_phase(void* first, void* end) {
  Block* block = static_cast<Block*>(first);
  do {
    assume<known>(*block);
    (block->*phase)();
  } while (++block != end);
}

template <class Block, void (Block::*phase)()>
constexpr Kernels kernels_of() {
  Kernels kernels;
  kernels[Known::nothing] = run_phase<Block, phase, Known::nothing>;
  kernels[Known::one_element] = run_phase<Block, phase, Known::one_element>;
  if constexpr (requires(const Block& block) { block.u.count(); }) {
    kernels[Known::two_in_list] = run_phase<Block, phase, Known::two_in_list>;
    kernels[Known::three_in_list] = run_phase<Block, phase, Known::three_in_list>;
  }
  if constexpr (requires(const Block& block) { block.slope_is_input; })
    kernels[Known::plain_slope] = run_phase<Block, phase, Known::plain_slope>;
  return kernels;
}

}  // namespace detail

}  // namespace stepwire
