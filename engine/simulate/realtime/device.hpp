#pragma once

namespace stepwire::realtime {

/// Sensors and actuators of a loop: they fill the diagram's inputs and receive its outputs.
///
/// read() and write() are called in the loop thread, as a part of its step, and must neither wait, allocate
/// nor throw. Numbers are in SI. They are concatenated input by input (output by output) in the order of
/// Diagram::inputs (Diagram::outputs), each with all its elements.
class Device {
 public:
  virtual ~Device() = default;
  /// Starts the device. Called once in the loop thread, when all else is ready for the first deadline. May
  /// wait and throw.
  virtual void start() {}
  /// Fills the inputs before the first tick of a wake-up. Inputs that are not written keep their values, at
  /// first the defaults of the file.
  virtual void read(double* inputs) noexcept = 0;
  /// Receives the outputs after that tick is computed.
  virtual void write(const double* outputs) noexcept = 0;
  /// Receives the safe values when the loop ends or pauses. An output without a safe value has its last one.
  virtual void rest(const double* outputs) noexcept { write(outputs); }
  /// False once the device is not to be used any more. The loop ends then, before it evaluates the tick.
  virtual bool healthy() const noexcept { return true; }
};

/// Device without hardware: inputs keep their defaults, and outputs are discarded.
class NoDevice : public Device {
 public:
  void read(double*) noexcept override {}
  void write(const double*) noexcept override {}
};

}  // namespace stepwire::realtime
