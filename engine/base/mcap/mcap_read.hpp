#pragma once

#include <string>

#include "engine/base/table/record_table.hpp"

namespace stepwire::mcap {

/// The numbers of JSON messages in an MCAP file, a row for each message: a column for each member, "a.b" for
/// those of objects in objects and "a.1" for those of lists, with the word `unit` of its schema. Of several
/// channels with messages, each column has the topic before it: "run-1/cart.position". A channel whose
/// messages have no member `time` gets it of their log time, in s from the first one of the file. Messages in
/// other encodings are left out; a member that a message lacks, or has as null, is nan. Throws TableError, with
/// the name of the file, for what is none, is damaged, packed, or has no JSON messages; EnvironmentError where
/// it cannot be read.
table::RecordTable read_mcap(const std::string& path);

}  // namespace stepwire::mcap
