#pragma once

#include <atomic>
#include <string>

#include "engine/app/studio/live/loaded_run.hpp"
#include "engine/simulate/replay/verify.hpp"

namespace stepwire::live {

/// Writes a live run as it is by now into a folder: what it recorded, the flattened diagram with copies of
/// its data files, and live.json, all that was done to the run with the ticks at which it acted. Only the way
/// that led here is kept: what a return to an earlier moment took back is not. Throws std::runtime_error
/// where nothing is recorded, EnvironmentError.
void write_live_folder(const std::string& folder, LoadedRun& run);

/// Where the run of a diagram is kept if no folder was named: for `rig/cart.yaml` the folder `rig/cart-run`.
std::string folder_beside(const std::string& diagram);

/// Is it such a folder?
bool is_live_folder(const std::string& folder);

/// Replays a live run from its folder and compares all signals that were recorded bit by bit. Throws Error or
/// TableError where the folder is damaged, EnvironmentError.
replay::Verification verify_live(const std::string& folder, const Registry& registry,
                                 const std::atomic<bool>* interrupt = nullptr);

}  // namespace stepwire::live
