#pragma once

#include <cstdint>
#include <mutex>
#include <string>
#include <utility>

namespace stepwire::hdf5 {

/// An identifier of the library, closed at the end. The library's own types are integers.
class Handle {
 public:
  using Close = int (*)(std::int64_t);

  Handle() = default;
  Handle(std::int64_t id, Close close) : id_(id), close_(close) {}
  ~Handle() { close(); }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }

  explicit operator bool() const { return id_ >= 0; }
  std::int64_t id() const { return id_; }
  /// False where the library refuses, as where a disk is full.
  bool close() { return id_ < 0 || close_(std::exchange(id_, -1)) >= 0; }

 private:
  std::int64_t id_ = -1;
  Close close_ = nullptr;
};

/// The library keeps all it has in variables of the program: one call at a time. While this lives the library
/// prints nothing, and keeps what went wrong.
class Session {
 public:
  Session();

  /// The library's own words for what went wrong first; the system's reason where it has one. Empty where
  /// nothing did.
  static std::string complaint();
  /// Throws TableError, the library's words behind ours.
  [[noreturn]] static void refuse(const std::string& what);

 private:
  std::lock_guard<std::recursive_mutex> lock_;
};

}  // namespace stepwire::hdf5
