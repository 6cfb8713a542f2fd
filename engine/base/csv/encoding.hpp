#pragma once

#include <string>

namespace stepwire::csv {

/// A text in UTF-8 and the original encoding of its file.
struct DecodedText {
  std::string text;
  std::string encoding;  ///< name for messages; empty for plain UTF-8
};

/// Decodes a text file. UTF-8 and UTF-16 are recognised by byte-order marks, UTF-16 without one by its zero
/// bytes; invalid UTF-8 is read as Windows-1252. Throws TableError, without the name of the file, for UTF-32
/// and for UTF-16 that ends within a character.
DecodedText decode(std::string bytes);

}  // namespace stepwire::csv
