#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/simulate/devices/channel_io.hpp"
#include "engine/simulate/devices/loop_rig.hpp"
#include "engine/simulate/realtime/device.hpp"
#include "engine/simulate/realtime/loop_clock.hpp"

namespace stepwire::devices {

/// Ports of a diagram behind a rig: conversion, filters, limits and rates of change.
class WiredDevice : public realtime::Device {
 public:
  /// start() returns early once `interrupt` is true.
  WiredDevice(const Wiring& wiring, ChannelIo& io, const std::atomic<bool>* interrupt = nullptr);

  void start() override { io_.start(interrupt_); }
  void read(double* inputs) noexcept override;
  void write(const double* outputs) noexcept override;
  void rest(const double* outputs) noexcept override;
  bool healthy() const noexcept override { return healthy_; }

  /// Returns a line for each output that its limits or its rate have changed.
  std::vector<std::string> limited() const;

 private:
  struct Output {
    OutputWire wire;
    double last = 0.0;  ///< SI
    std::int64_t at_limit = 0, at_rate = 0;
  };

  double within(Output& output, double wanted) const noexcept;
  void forget() noexcept;

  ChannelIo& io_;
  const std::atomic<bool>* interrupt_;
  std::vector<InputWire> inputs_;
  std::vector<Output> outputs_;
  std::vector<double> safe_, sensed_, commanded_, filtered_;
  std::int64_t steps_ = 0;
  bool healthy_ = true, begun_ = false;
};

/// Clock of a loop whose deadlines are the samples of a device.
class DeviceClock : public realtime::LoopClock {
 public:
  DeviceClock(driver::OpenDevice& device, std::int64_t period)
      : device_(device), period_(period), values_(device.inputs().size()) {}

  std::int64_t now() override { return clock_.now() + ahead_; }
  void sleep_until(std::int64_t deadline) override;
  /// Returns a line where the samples have another period than the loop, whose times are then not those of
  /// the device; "" otherwise.
  std::string other_period() const;

 private:
  driver::OpenDevice& device_;
  std::int64_t period_;
  std::vector<double> values_;
  realtime::SystemClock clock_;
  std::int64_t ahead_ = 0;  ///< of the system's clock
  std::int64_t first_ = 0, last_ = 0,
               samples_ = 0;  ///< times of the first and the last sample, samples since
};

/// Opened and checked rig of a loop.
class Rig : public LoopRig {
 public:
  /// Checks a rig file against the diagram and its devices, which a process of its own opens and closes.
  /// Then its guard, or without one this process, opens them. Throws Error and EnvironmentError.
  /// `period` is that of the loop [s]; `priority` is that of a guard, see GuardedIo. `interrupt` ends the
  /// wait for drivers, here by ProcessStopped and in device().start().
  Rig(const std::string& file, const plan::Plan& plan, double period, int priority = 0,
      const std::atomic<bool>* interrupt = nullptr)
      : Rig(read_io(file), Ports::of(plan), period, priority, interrupt) {}
  Rig(const IoRequest& request, const Ports& ports, double period, int priority = 0,
      const std::atomic<bool>* interrupt = nullptr);

  realtime::Device& device() override { return *device_; }
  realtime::LoopClock* clock() override { return clock_.get(); }
  std::vector<std::string> notes() const override { return wiring_.notes; }
  /// The reason why the rig is not to be used any more comes first, then failures of drivers at the end.
  std::string trouble() const override;
  const std::vector<InputWire>& inputs() const { return wiring_.inputs; }
  std::vector<std::string> finish() override;

 private:
  std::unique_ptr<guard::Bank> bank_;
  Wiring wiring_;
  std::unique_ptr<ChannelIo> io_;
  std::unique_ptr<WiredDevice> device_;
  std::unique_ptr<DeviceClock> clock_;
  std::vector<std::string> failures_;  ///< of drivers at the end
};

}  // namespace stepwire::devices
