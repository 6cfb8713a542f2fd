#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/session/loaded_model.hpp"
#include "engine/app/session/loop_settings.hpp"
#include "engine/app/session/monitor.hpp"
#include "engine/base/result/record.hpp"
#include "engine/simulate/devices/hosted_plant.hpp"
#include "engine/simulate/realtime/cyclictest.hpp"
#include "engine/simulate/realtime/loop.hpp"
#include "engine/simulate/realtime/serve.hpp"
#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::session {

/// Numbers of written and lost rows of a loop.
struct LoopRows {
  std::int64_t written = 0;
  std::int64_t lost_to_ring = 0;  ///< lost because the writer was too slow
  std::int64_t lost_to_disk = 0;
  std::string trouble;  ///< error of the file system

  std::int64_t lost() const { return lost_to_ring + lost_to_disk; }
};

/// Results of a loop; `loop` has the measurements.
struct LoopOutcome {
  const realtime::Loop& loop;
  const LoopSettings& settings;
  realtime::Served served;
  std::optional<LoopRows> rows;  ///< std::nullopt if no rows were recorded
  std::optional<realtime::Cyclictest> baseline;
  bool has_devices = false;                 ///< true with a rig
  std::string device_fault{};               ///< why the devices ended the loop; empty if they did not
  std::vector<std::string> device_lines{};  ///< counts of the devices, outputs that limits have changed
};

/// Declares the fields of loop.json.
void declare(result::Record<LoopOutcome>& is);

/// Options of a real-time loop.
struct LoopCall {
  std::string file;
  LoadOptions load;
  LoopWords words;
  std::string io;                             ///< rig file; empty: no devices
  std::optional<devices::PlantCall> plant{};  ///< offers the diagram as a plant, in place of a rig file
  std::string out;                            ///< folder; empty: nothing is recorded
  bool baseline = false;
  run::ExecutionMode engine = run::ExecutionMode::interpreted;
};

/// Runs a file in real time with its own values, without judging claims. Writes rows, loop.json and loop.svg
/// into the folder, if there is one.
/// `report` gets the outcome, which is valid during that call. Throws Error and EnvironmentError.
void run_loop(const LoopCall& call, const Registry& registry, const Monitor& monitor,
              const std::function<void(const LoopOutcome&)>& report);

/// Returns "done", "stopped", ...
std::string end_word(realtime::Loop::End end);

}  // namespace stepwire::session
