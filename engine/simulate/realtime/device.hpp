#pragma once

namespace stepwire::realtime {

/// Sensors and actuators of a loop: they fill the diagram's inputs and receive its outputs.
///
/// Both functions are called in the loop thread, as a part of its step, and must neither wait, allocate nor
/// throw. Numbers are in SI. They are concatenated input by input (output by output) in the order of
/// Diagram::inputs (Diagram::outputs), each with all its elements.
class Device {
 public:
  virtual ~Device() = default;
  /// Fills the inputs before the first tick of a wake-up. Inputs that are not written keep their values, at
  /// first the defaults of the file.
  virtual void read(double* inputs) noexcept = 0;
  /// Receives the outputs after that tick is computed, and once more, with the safe values, when the loop
  /// ends. An output without a safe value keeps its last one.
  virtual void write(const double* outputs) noexcept = 0;
};

/// Device without hardware: inputs keep their defaults, and outputs are discarded.
class NoDevice : public Device {
 public:
  void read(double*) noexcept override {}
  void write(const double*) noexcept override {}
};

}  // namespace stepwire::realtime
