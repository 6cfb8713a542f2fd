#pragma once

namespace stepwire::realtime {

/// The outside world of a loop: sensors that fill the diagram's inputs, actuators that take its outputs.
///
/// Both functions are called in the loop thread and are part of its step: they must neither wait, allocate
/// nor throw. Numbers are in SI and lie one behind the other, input by input (output by output) in the order
/// of Diagram::inputs (Diagram::outputs), each with all its elements.
class Device {
 public:
  virtual ~Device() = default;
  /// Before the first tick of a wake-up. What is not written keeps what it was: at first the default of the
  /// file.
  virtual void read(double* inputs) noexcept = 0;
  /// After the outputs of that tick are computed; and once more, with the safe values, when the loop ends. An
  /// output without a safe value keeps its last one.
  virtual void write(const double* outputs) noexcept = 0;
};

/// No outside world: inputs keep their defaults, and nobody takes the outputs.
class NoDevice : public Device {
 public:
  void read(double*) noexcept override {}
  void write(const double*) noexcept override {}
};

}  // namespace stepwire::realtime
