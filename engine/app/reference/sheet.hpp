#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/model/block/block_type.hpp"

namespace stepwire {

/// One table of a reference page. The first column names things, the last explains them.
struct SheetTable {
  std::string title;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/// What a reference page says, before it is known how it looks.
struct BlockSheet {
  std::string name, folder, doc;
  std::vector<std::pair<std::string, std::string>> facts;  ///< label, text
  std::vector<SheetTable> tables;                          ///< without those that would be empty
  std::string remark;                                      ///< on unit variables, where there are any
  std::string example;
};

/// Takes out columns in which nothing stands.
void drop_empty_columns(SheetTable& table);

/// Gathers all that a declaration says.
BlockSheet sheet_of(const BlockType& type);

}  // namespace stepwire
