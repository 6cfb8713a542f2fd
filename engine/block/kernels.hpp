#pragma once

namespace stepwire {

/// Runs one phase of the blocks of one type, at least one, that lie one behind the other in memory up to
/// `end`.
using Kernel = void (*)(void* first, void* end);

/// The kernels of one phase. The more is known of a block, the less has to be asked at every step.
struct Kernels {
  Kernel any = nullptr;  ///< null where the type has no such phase
  Kernel one = nullptr;  ///< for blocks of which every port and state has one element
  Kernel one_of_two =
      nullptr;  ///< and that have two inputs in the list `u`; null where there is no such list

  explicit operator bool() const { return any != nullptr; }
};

namespace detail {

/// What a kernel may take for granted of its blocks.
enum class Known { nothing, one_element, one_element_of_two };

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
  if constexpr (known == Known::one_element_of_two)
    if (block.u.count() != 2) __builtin_unreachable();
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
  Kernels kernels{run_phase<Block, phase, Known::nothing>, run_phase<Block, phase, Known::one_element>};
  if constexpr (requires(const Block& block) { block.u.count(); })
    kernels.one_of_two = run_phase<Block, phase, Known::one_element_of_two>;
  return kernels;
}

}  // namespace detail

}  // namespace stepwire
