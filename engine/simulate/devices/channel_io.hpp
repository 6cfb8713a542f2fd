#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "engine/simulate/devices/wiring.hpp"
#include "engine/simulate/guard/running_guard.hpp"

namespace stepwire::devices {

/// Channels of all devices of a rig, for the thread of a loop. Values are in the units of the channels.
class ChannelIo {
 public:
  virtual ~ChannelIo() = default;
  /// Starts the devices, with outputs at their safe values, and waits for their first values, until
  /// `interrupt` is true. Throws EnvironmentError.
  virtual void start(const std::atomic<bool>* interrupt) = 0;
  /// Reads all inputs. Returns false once the rig is not to be used any more.
  virtual bool read(double* inputs) noexcept = 0;
  /// Writes all outputs, as far as the limits allow. Returns false as read() does.
  virtual bool write(const double* outputs) noexcept = 0;
  /// Sets all outputs to their safe values, between two parts of a loop and at its end.
  virtual void rest() noexcept = 0;
  /// Ends the use of the devices. Returns their lines of counts.
  virtual std::vector<std::string> finish() = 0;
  /// Returns why the rig is not to be used any more; "" if it is.
  virtual std::string trouble() const = 0;
};

/// Devices in the process of the loop.
class DirectIo : public ChannelIo {
 public:
  DirectIo(const Wiring& wiring, guard::Bank& bank);
  ~DirectIo() override;

  void start(const std::atomic<bool>* interrupt) override;
  bool read(double* inputs) noexcept override;
  bool write(const double* outputs) noexcept override;
  void rest() noexcept override;
  std::vector<std::string> finish() override;
  std::string trouble() const override { return watch_.text(); }

 private:
  bool accept(int result) noexcept;

  guard::Bank& bank_;
  std::int64_t wait_;
  guard::Watch watch_;
};

/// Devices that a guard has.
class GuardedIo : public ChannelIo {
 public:
  /// Starts the process of the guard, at the priority of SCHED_FIFO or with the default policy for 0. Throws
  /// EnvironmentError.
  GuardedIo(const Wiring& wiring, int priority);

  void start(const std::atomic<bool>* interrupt) override { guard_.start(interrupt); }
  bool read(double* inputs) noexcept override { return guard_.inputs(inputs); }
  bool write(const double* outputs) noexcept override { return guard_.command(outputs); }
  void rest() noexcept override { guard_.rest(); }
  std::vector<std::string> finish() override;
  std::string trouble() const override { return guard_.trouble(); }

 private:
  guard::RunningGuard guard_;
};

}  // namespace stepwire::devices
