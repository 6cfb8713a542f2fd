#pragma once

#include <cstdint>
#include <mutex>
#include <string>
#include <utility>

namespace stepwire::hdf5 {

/// Owner of an HDF5 identifier. The type of the library is an integer as well.
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
  /// Closes it; false where the library fails, for example on a full disk.
  bool close() { return id_ < 0 || close_(std::exchange(id_, -1)) >= 0; }

 private:
  std::int64_t id_ = -1;
  Close close_ = nullptr;
};

/// Lock of the HDF5 library, which has global state: one call at a time. During its lifetime the library
/// prints nothing and keeps its error stack.
class Session {
 public:
  Session();

  /// Returns the first error of the library, or the system's reason if there is one; empty without an error.
  static std::string complaint();
  /// Throws TableError with the library's error appended.
  [[noreturn]] static void refuse(const std::string& what);

 private:
  std::lock_guard<std::recursive_mutex> lock_;
};

}  // namespace stepwire::hdf5
