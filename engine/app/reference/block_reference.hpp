#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/model/block/block_type.hpp"

namespace stepwire::reference {

/// One table of a reference page. The first column names things, the last explains them.
struct ReferenceTable {
  std::string title;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/// What a reference page says, before it is known how it looks.
struct BlockReference {
  std::string name, folder, doc;
  std::vector<std::pair<std::string, std::string>> facts;  ///< label, text
  std::vector<ReferenceTable> tables;                      ///< without those that would be empty
  std::string remark;                                      ///< on unit variables, where there are any
  std::string example;
};

/// Takes out columns in which nothing stands.
void drop_empty_columns(ReferenceTable& table);

/// Gathers all that a declaration says.
BlockReference reference_of(const BlockType& type);

}  // namespace stepwire::reference
