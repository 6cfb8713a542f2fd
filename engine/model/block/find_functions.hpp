#pragma once

#include "engine/model/block/block_type.hpp"
#include "engine/model/block/crossings.hpp"
#include "engine/model/block/kernels.hpp"

namespace stepwire {

namespace detail {

template <class Block>
void find_phases(BlockType& type) {
  if constexpr (requires(Block b) { b.outputs(); }) type.run_outputs = kernels_of<Block, &Block::outputs>();
  if constexpr (requires(Block b) { b.outputs_at_instant(); })
    type.run_outputs_at_instant = kernels_of<Block, &Block::outputs_at_instant>();
  if constexpr (requires(Block b) { b.derivatives(); })
    type.run_derivatives = kernels_of<Block, &Block::derivatives>();
  if constexpr (requires(Block b) { b.update(); }) type.run_update = kernels_of<Block, &Block::update>();
  if constexpr (requires(Block b) { b.update_at_event(); })
    type.run_update_at_event = kernels_of<Block, &Block::update_at_event>();
  if constexpr (requires(Block b) { b.update_before_instant(); })
    type.run_update_before_instant = kernels_of<Block, &Block::update_before_instant>();
}

template <class Block>
void find_events(BlockType& type) {
  if constexpr (requires(const Block b, Crossings& zero) { b.crossings(zero); })
    type.run_crossings = [](const void* block, double* numbers) {
      Crossings zero(numbers);
      Called<const Block>(block)->crossings(zero);
    };
  if constexpr (requires(const Block b) { b.next_edge(); })
    type.run_next_edge = [](const void* block) -> double { return Called<const Block>(block)->next_edge(); };
}

template <class Block>
void find_set_up(BlockType& type) {
  if constexpr (requires(Block b, Configure & is) { b.configure(is); })
    type.configure = [](void* block, Configure& is) { Called<Block>(block)->configure(is); };
  if constexpr (requires(Block b) { b.prepare(); })
    type.prepare = [](void* block) { Called<Block>(block)->prepare(); };
  if constexpr (requires(const Block b, Outline& lines) { b.outline(lines); })
    type.outline = [](const void* block, Outline& lines) { Called<const Block>(block)->outline(lines); };
  if constexpr (requires(Block b) { b.start(); })
    type.start = [](void* block) { Called<Block>(block)->start(); };
}

/// Detects the functions that a block's struct defines.
template <class Block>
void find_functions(BlockType& type) {
  find_phases<Block>(type);
  find_events<Block>(type);
  find_set_up<Block>(type);
}

}  // namespace detail

}  // namespace stepwire
