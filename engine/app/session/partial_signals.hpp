#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "engine/app/session/loaded_model.hpp"
#include "engine/base/hdf5/hdf5_writer.hpp"
#include "engine/simulate/run/observer.hpp"

namespace stepwire::session {

/// Keeps what a long run records in HDF5 files of a folder while it goes on, `signals.h5.partial` and those
/// of further periods: what is left of a run whose process is killed. Rows come there each second, after the
/// first two seconds. For a run without a sweep.
class PartialSignals : public run::RunObserver {
 public:
  PartialSignals(std::string folder, const LoadedModel& model);
  ~PartialSignals() override;
  PartialSignals(const PartialSignals&) = delete;
  PartialSignals& operator=(const PartialSignals&) = delete;

  void row(const run::ObservedRun& run, std::size_t recording, std::span<const double> numbers) override;
  /// Removes the files: what was recorded is kept elsewhere.
  void remove();

 private:
  using Clock = std::chrono::steady_clock;
  struct File;

  void write();

  std::vector<std::unique_ptr<File>> files_;  ///< by recording
  Clock::time_point due_;
  bool refused_ = false;  ///< the system takes no more; the run goes on
};

}  // namespace stepwire::session
