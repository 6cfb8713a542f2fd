#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "engine/base/io/leftovers.hpp"

namespace stepwire::io {

/// A file that is written piece by piece under a temporary name beside `path`, which it replaces at the end;
/// without finish() nothing of it is left, and the file before keeps its content. A piece that the system
/// refuses is not in the file, nor is a part of it.
class AtomicFileWriter {
 public:
  /// Missing folders are made. Throws EnvironmentError with the system's reason.
  explicit AtomicFileWriter(const std::string& path);
  ~AtomicFileWriter();
  AtomicFileWriter(const AtomicFileWriter&) = delete;
  AtomicFileWriter& operator=(const AtomicFileWriter&) = delete;

  /// Writes a piece behind the others. Throws EnvironmentError where the system refuses it, as does finish()
  /// then.
  void append(std::string_view piece);
  /// Writes a piece that may be lost, for callers that count what is. False where the system refuses it; a
  /// later piece may fit again.
  [[nodiscard]] bool try_append(std::string_view piece);
  /// Where the file is until it has its name, for a library that writes it by itself.
  const std::string& temporary() const { return temporary_; }
  /// "PATH: No space left on device", of the first piece that was refused; empty if none was.
  const std::string& trouble() const { return trouble_; }
  /// Gives the file its name. Throws EnvironmentError with the system's reason, or with that of append().
  void finish();

 private:
  bool write_all(std::string_view piece);

  std::string path_, temporary_, trouble_;
  Leftover leftover_;
  int file_ = -1;
  bool incomplete_ = false;  ///< append() was refused
  std::int64_t size_ = 0;  ///< [bytes] of whole pieces
};

}  // namespace stepwire::io
