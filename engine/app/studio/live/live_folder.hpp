#pragma once

#include <atomic>
#include <string>

#include "engine/app/studio/live/loaded_run.hpp"
#include "engine/simulate/replay/verify.hpp"

namespace stepwire::live {

/// Writes the present state of a live run into a folder: its records, the flattened diagram with copies of
/// its data files, and live.json. The latter contains all events with their ticks, except those that a return
/// to an earlier tick has removed. Throws std::runtime_error if nothing is recorded, EnvironmentError.
void write_live_folder(const std::string& folder, LoadedRun& run);

/// Returns the default folder for the run of a diagram: `rig/cart-run` for `rig/cart.yaml`.
std::string folder_beside(const std::string& diagram);

/// True if write_live_folder() wrote this folder.
bool is_live_folder(const std::string& folder);

/// Replays a live run from its folder and compares all recorded signals bit by bit. Throws Error or
/// TableError if the folder is damaged, EnvironmentError.
replay::Verification verify_live(const std::string& folder, const Registry& registry,
                                 const std::atomic<bool>* interrupt = nullptr);

}  // namespace stepwire::live
