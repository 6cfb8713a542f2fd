#pragma once

#include <utility>

#include "engine/base/math/floating_point.hpp"

struct _object;  // PyObject; Python's headers are included only by sources of this room

namespace stepwire::python {

/// Guard that holds the interpreter lock during its lifetime. It may be used on any thread, and nested.
/// The first lock on a foreign thread registers the thread with Python until the thread ends, so later locks
/// are cheap. The destructor restores the floating-point state that Python code may have changed.
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

/// Guard that releases the interpreter lock of this thread, which must hold it. It sets the usual
/// floating-point state meanwhile.
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

/// Owning reference to a Python object, which any thread may drop.
class Held {
 public:
  Held() = default;
  /// Takes over a reference that the caller owns.
  explicit Held(_object* owned) : object_(owned) {}
  /// Adds a reference. The caller must hold the interpreter lock.
  static Held one_more(_object* object);
  ~Held();
  Held(Held&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
  Held& operator=(Held&& other) noexcept {
    std::swap(object_, other.object_);
    return *this;
  }

  /// Replaces the reference by an owned one. The caller must hold the interpreter lock, which saves the
  /// locking.
  void put(_object* owned);
  _object* get() const { return object_; }
  /// Releases ownership of the reference.
  _object* release() { return std::exchange(object_, nullptr); }
  explicit operator bool() const { return object_ != nullptr; }

 private:
  _object* object_ = nullptr;
};

}  // namespace stepwire::python
