#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <new>

#ifdef STEPWIRE_BLOCKS_FROM_OUTSIDE
#include "engine/base/math/floating_point.hpp"
#endif

namespace stepwire {

/// Runs one phase of one or more blocks of one type, which are contiguous in memory up to `end`.
using Kernel = void (*)(void* first, void* end);

/// Compile-time assumptions of a kernel about its blocks. They avoid checks at every step.
enum class Specialization {
  nothing,
  one_element,    ///< Every port and state has one element.
  two_in_list,    ///< In addition, the list of inputs `u` has two elements.
  three_in_list,  ///< In addition, it has three elements.
  plain_slope,    ///< One element; the derivative equals the input (`slope_is_input` of the block).
  count
};

/// Kernels of one phase, by their assumptions.
class Kernels {
 public:
  /// Returns a kernel; nullptr where the type lacks this phase or the assumption does not apply to it.
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

/// Guard around calls of a block's functions. External blocks are foreign code: their folder is compiled with
/// STEPWIRE_BLOCKS_FROM_OUTSIDE, and the guard restores the floating-point state after each call. For blocks
/// of the library it is empty.
#ifdef STEPWIRE_BLOCKS_FROM_OUTSIDE
using BlockCall = FloatingPointState;
#else
struct BlockCall {};
#endif

/// Access to a block for a call of one of its functions, guarded by BlockCall.
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

/// Passes the assumptions to the compiler. Sizes are assumed only for the conventional names u, y and x,
/// which most blocks use.
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
