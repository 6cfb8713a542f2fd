#pragma once

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>

#include "engine/simulate/device/piece.hpp"

namespace stepwire::device {

/// Failure of a device or its driver, as a sentence.
class DeviceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Kernel that a device has loaded.
class Kernel {
 public:
  virtual ~Kernel() = default;
  /// Steps the runs of a piece and waits for the end. Throws DeviceError.
  virtual void step(const Piece& piece) = 0;
};

/// Device with a memory of its own. Thread-safe. All functions but the destructor and release() throw
/// DeviceError.
class Device {
 public:
  virtual ~Device() = default;
  virtual std::string name() const = 0;
  /// Returns the free memory [bytes].
  virtual std::size_t free_memory() = 0;
  virtual void* allocate(std::size_t bytes) = 0;
  virtual void release(void* memory) noexcept = 0;
  virtual void write(void* memory, const void* from, std::size_t bytes) = 0;
  virtual void read(void* to, const void* memory, std::size_t bytes) = 0;
  /// Loads the PTX of a kernel. The device must outlive it.
  virtual std::unique_ptr<Kernel> load(const std::string& ptx) = 0;
};

/// Numbers in the memory of a device.
template <class Number>
class DeviceNumbers {
 public:
  DeviceNumbers(Device& device, std::size_t count)
      : device_(device),
        count_(count),
        memory_(static_cast<Number*>(device.allocate((count > 0 ? count : 1) * sizeof(Number)))) {}
  ~DeviceNumbers() { device_.release(memory_); }
  DeviceNumbers(const DeviceNumbers&) = delete;
  DeviceNumbers& operator=(const DeviceNumbers&) = delete;

  Number* data() const { return memory_; }
  void write(const Number* from) { device_.write(memory_, from, count_ * sizeof(Number)); }
  void read(Number* to) const { read(to, count_); }
  /// Reads the first `count` numbers.
  void read(Number* to, std::size_t count) const { device_.read(to, memory_, count * sizeof(Number)); }

 private:
  Device& device_;
  std::size_t count_;
  Number* memory_;
};

}  // namespace stepwire::device
