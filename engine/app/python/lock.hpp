#pragma once

#include <utility>

#include "engine/base/math/floating_point.hpp"

struct _object;  // PyObject of Python's headers, which stay in the sources of this room

namespace stepwire::python {

/// Holds the interpreter lock for as long as it lives; from any thread, also where it is held already. The
/// first one of a thread that Python does not know makes that thread known until it ends: the next ones are
/// cheap. The floating-point state that Python code leaves ends with the lock.
class Lock {
 public:
  Lock();
  ~Lock();
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
  FloatingPointState kept_{};
  int state_;
};

/// Lets go of the interpreter lock, which this thread holds, for as long as it lives. The floating-point
/// state is the usual one meanwhile, whatever Python code has set.
class Unlocked {
 public:
  Unlocked();
  ~Unlocked();
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;

 private:
  UsualFloatingPoint usual_{};
  void* thread_;
};

/// A reference to an object of Python's that any thread may drop.
class Held {
 public:
  Held() = default;
  /// Takes over a reference that the caller owns.
  explicit Held(_object* owned) : object_(owned) {}
  /// Holds one more. The lock is held.
  static Held one_more(_object* object);
  ~Held();
  Held(Held&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
  Held& operator=(Held&& other) noexcept {
    std::swap(object_, other.object_);
    return *this;
  }

  /// Takes over another reference and drops this one; the lock is held, which is faster.
  void put(_object* owned);
  _object* get() const { return object_; }
  /// Hands the reference over.
  _object* release() { return std::exchange(object_, nullptr); }
  explicit operator bool() const { return object_ != nullptr; }

 private:
  _object* object_ = nullptr;
};

}  // namespace stepwire::python
