#pragma once

#include <string>

#include "engine/base/table/record_table.hpp"

namespace stepwire::mcap {

/// Reads the numbers of JSON messages in an MCAP file, one row for each message. A column is a member: "a.b"
/// for one of a nested object, "a.1" for an element of a list. Its unit is the word `unit` of the schema. If
/// several channels have messages, the topic precedes each column: "run-1/cart.position".
///
/// A channel without a member `time` gets one from its log times, in s since the first message of the file.
/// Messages in other encodings are left out. A missing or null member is NaN. Throws TableError, with the
/// name of the file, for another format, damage, compression, or no JSON messages. Throws EnvironmentError
/// for an unreadable file.
table::RecordTable read_mcap(const std::string& path);

}  // namespace stepwire::mcap
