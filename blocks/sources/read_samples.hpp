#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "blocks/sources/from_file.hpp"
#include "engine/base/table/record_table.hpp"

namespace stepwire {

/// A record as a FromFile plays it: in SI, cut to its range and prepared.
struct PlayedRecord {
  std::weak_ptr<const table::RecordTable> table;  ///< that it was made of
  Samples samples;
  BandLimited smooth;                ///< of the columns, where band-limited
  std::optional<std::string> unit;   ///< where all columns have one and the same
  std::vector<std::string> notes{};  ///< how the file was read, for people
};

/// Reads what a FromFile asks for; refuses its parameters where the file does not fit them. The same record
/// is prepared once for all blocks and runs, as long as its file has not changed.
std::shared_ptr<const PlayedRecord> read_samples(const FromFile& asked, Configure& is);

}  // namespace stepwire
