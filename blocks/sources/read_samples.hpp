#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "blocks/sources/from_file.hpp"
#include "engine/base/table/record_table.hpp"

namespace stepwire {

/// Record of a FromFile: in SI, cut to its range and prepared.
struct PlayedRecord {
  std::weak_ptr<const table::RecordTable> table;  ///< table that it was made from
  Samples samples;
  BandLimited smooth;                ///< of the columns, if band-limited
  std::optional<std::string> unit;   ///< set if all columns have the same one
  std::vector<std::string> notes{};  ///< how the file was read, for the user
  std::string late{};                ///< refusal of a start that rows without a value move; else empty
  double origin = 0.0;               ///< time of the file at which those of the samples are 0 [s]
  std::string uneven{};              ///< refusal of a period that rows without a value change; else empty
};

/// Reads the record of a FromFile and refuses parameters that do not fit the file. The same record is
/// prepared once for all blocks and runs, while its file is unchanged.
std::shared_ptr<const PlayedRecord> read_samples(const FromFile& asked, Configure& is);

}  // namespace stepwire
