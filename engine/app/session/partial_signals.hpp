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

/// Observer that writes the rows of a long run to HDF5 files, so that they survive a kill of the process. The
/// files are `signals.h5.partial`, and one for each further period.
/// It writes every second, after the first two seconds. It supports runs without a sweep.
class PartialSignals : public run::RunObserver {
 public:
  PartialSignals(std::string folder, const LoadedModel& model);
  ~PartialSignals() override;
  PartialSignals(const PartialSignals&) = delete;
  PartialSignals& operator=(const PartialSignals&) = delete;

  void row(const run::ObservedRun& run, std::size_t recording, std::span<const double> numbers) override;
  /// Removes the files, after the results are stored elsewhere.
  void remove();

 private:
  using Clock = std::chrono::steady_clock;
  struct File;

  void write();

  std::vector<std::unique_ptr<File>> files_;  ///< by recording
  Clock::time_point due_;
  bool refused_ = false;  ///< a write has failed; the run continues
};

}  // namespace stepwire::session
