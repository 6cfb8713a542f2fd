#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/base/json/json.hpp"
#include "engine/base/table/run_view.hpp"

namespace stepwire::mcap {

/// Layout of a row of a run as a JSON object. The dotted parts of a name become nested objects, so that
/// viewers can unfold them. Where `a` itself is a column, `a.b` is a plain member of that name. The run must
/// outlive the layout.
class RowShape {
 public:
  explicit RowShape(const table::RunView& run);

  /// Returns the JSON schema of a row, with units.
  std::string schema(const std::string& title) const;
  void append_row(std::string& text, std::size_t row) const;

 private:
  /// A member: a column, or an object with further members.
  struct Member {
    std::string key;
    const table::SeriesView* series = nullptr;
    std::vector<Member> members{};
  };

  bool is_column(const std::string& name) const;
  void add(const table::SeriesView& series);
  static json::Json schema_of(const Member& member);
  void spell(const Member& member, std::string& text);

  const table::RunView& run_;
  Member root_;
  /// Precomputed text followed by the number of its column; a row is all pieces and `end_`.
  struct Piece {
    std::string text;
    const table::SeriesView* series;
  };
  std::vector<Piece> pieces_;
  std::string end_;
};

}  // namespace stepwire::mcap
