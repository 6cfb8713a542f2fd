#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/model/block/block_type.hpp"

namespace stepwire::reference {

/// Table of a reference page. The first column has names, the last one explanations.
struct ReferenceTable {
  std::string title;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/// Content of a reference page, independent of its output format.
struct BlockReference {
  std::string name, folder, doc;
  std::vector<std::pair<std::string, std::string>> facts;  ///< label, text
  std::vector<ReferenceTable> tables;                      ///< without empty tables
  std::string remark;                                      ///< note on unit variables; may be empty
  std::string example;
};

/// Removes columns whose cells are all empty.
void drop_empty_columns(ReferenceTable& table);

/// Collects the content of a block's declaration.
BlockReference reference_of(const BlockType& type);

}  // namespace stepwire::reference
