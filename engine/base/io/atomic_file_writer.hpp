#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "engine/base/io/leftovers.hpp"

namespace stepwire::io {

/// Writes a file in pieces under a temporary name beside `path`, and replaces `path` at the end. Without
/// finish() the temporary file is removed and an earlier file keeps its content. A piece is written
/// completely or not at all.
class AtomicFileWriter {
 public:
  /// Creates the temporary file and missing folders. Throws EnvironmentError with the system's reason.
  explicit AtomicFileWriter(const std::string& path);
  ~AtomicFileWriter();
  AtomicFileWriter(const AtomicFileWriter&) = delete;
  AtomicFileWriter& operator=(const AtomicFileWriter&) = delete;

  /// Appends a piece. Throws EnvironmentError where the system refuses it; finish() then throws as well.
  void append(std::string_view piece);
  /// Appends a piece that may be lost. Returns false where the system refuses it; a later piece may fit
  /// again.
  [[nodiscard]] bool try_append(std::string_view piece);
  /// Renames the file to its final name already now, where the system allows it; later pieces follow. Its
  /// content is then kept whatever ends the process.
  void publish() noexcept;
  /// Path of the temporary file, for a library that writes it by itself.
  const std::string& temporary() const { return temporary_; }
  /// Returns the error of the first refused piece, as "PATH: No space left on device"; empty without one.
  const std::string& trouble() const { return trouble_; }
  /// Renames the file to its final name. Throws EnvironmentError with the system's reason, or with that of
  /// append().
  void finish();

 private:
  bool write_all(std::string_view piece);

  std::string path_, temporary_, trouble_;
  Leftover leftover_;
  int file_ = -1;
  bool incomplete_ = false;  ///< append() failed
  bool published_ = false;
  std::int64_t size_ = 0;  ///< [bytes] of complete pieces
};

}  // namespace stepwire::io
