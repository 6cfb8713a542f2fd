#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <new>

#ifdef STEPWIRE_BLOCKS_FROM_OUTSIDE
#include "engine/base/math/floating_point.hpp"
#endif

namespace stepwire {

/// Runs one phase of the blocks of one type, at least one, that lie one behind the other in memory up to
/// `end`.
using Kernel = void (*)(void* first, void* end);

/// What a kernel may take for granted of its blocks. The more is known, the less has to be asked at every
/// step.
enum class Specialization {
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
  Kernel operator[](Specialization specialization) const {
    return kernels_[static_cast<std::size_t>(specialization)];
  }
  Kernel& operator[](Specialization specialization) {
    return kernels_[static_cast<std::size_t>(specialization)];
  }
  explicit operator bool() const { return (*this)[Specialization::nothing] != nullptr; }
  bool contains(Kernel kernel) const {
    return std::find(kernels_.begin(), kernels_.end(), kernel) != kernels_.end();
  }

 private:
  std::array<Kernel, static_cast<std::size_t>(Specialization::count)> kernels_{};
};

namespace detail {

/// Surrounds a call of a block's own function. Blocks from outside are foreign code: the sources of their
/// folder are compiled with STEPWIRE_BLOCKS_FROM_OUTSIDE, and behind each call the floating-point state is as
/// before. For blocks of the library it is empty.
#ifdef STEPWIRE_BLOCKS_FROM_OUTSIDE
using BlockCall = FloatingPointState;
#else
struct BlockCall {};
#endif

/// A block in an expression that calls one of its own functions.
template <class Block>
class Called {
 public:
  explicit Called(const void* block) : block_(static_cast<Block*>(const_cast<void*>(block))) {}
  Block* operator->() const { return block_; }
  Block& operator*() const { return *block_; }

 private:
  Block* block_;
  [[no_unique_address]] BlockCall call_{};
};

template <class Block>
void construct(void* memory) {
  [[maybe_unused]] const BlockCall call;
  ::new (memory) Block{};
}

template <class Block>
void copy(void* memory, const void* block) {
  ::new (memory) Block(*Called<const Block>(block));
}

template <class Port>
[[gnu::always_inline]] inline void assume_one_element(const Port& port) {
  if constexpr (requires { port.size(); })
    if (port.size() != 1) __builtin_unreachable();
}

/// Tells the compiler what is known. The ports and the state that most blocks have, with the names that they
/// have by custom, are enough: sizes are asked of what is written.
template <Specialization specialization, class Block>
[[gnu::always_inline]] inline void assume(const Block& block) {
  if constexpr (specialization == Specialization::nothing) return;
  if constexpr (requires { block.u.size(); }) assume_one_element(block.u);
  if constexpr (requires { block.y.size(); }) assume_one_element(block.y);
  if constexpr (requires { block.x.derivative.size(); }) assume_one_element(block.x.derivative);
  if constexpr (specialization == Specialization::two_in_list)
    if (block.u.count() != 2) __builtin_unreachable();
  if constexpr (specialization == Specialization::three_in_list)
    if (block.u.count() != 3) __builtin_unreachable();
  if constexpr (specialization == Specialization::plain_slope)
    if (!block.slope_is_input) __builtin_unreachable();
}

template <class Block, void (Block::*phase)(), Specialization specialization>
void run_phase(void* first, void* end) {
  Block* block = static_cast<Block*>(first);
  do {
    assume<specialization>(*block);
    [[maybe_unused]] const BlockCall call;
    (block->*phase)();
  } while (++block != end);
}

template <class Block, void (Block::*phase)()>
constexpr Kernels kernels_of() {
  Kernels kernels;
  kernels[Specialization::nothing] = run_phase<Block, phase, Specialization::nothing>;
  kernels[Specialization::one_element] = run_phase<Block, phase, Specialization::one_element>;
  if constexpr (requires(const Block& block) { block.u.count(); }) {
    kernels[Specialization::two_in_list] = run_phase<Block, phase, Specialization::two_in_list>;
    kernels[Specialization::three_in_list] = run_phase<Block, phase, Specialization::three_in_list>;
  }
  if constexpr (requires(const Block& block) { block.slope_is_input; })
    kernels[Specialization::plain_slope] = run_phase<Block, phase, Specialization::plain_slope>;
  return kernels;
}

}  // namespace detail

}  // namespace stepwire
