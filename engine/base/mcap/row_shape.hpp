#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/base/json/json.hpp"
#include "engine/base/table/run_view.hpp"

namespace stepwire::mcap {

/// A row of a run as a JSON object. The parts of a name between points are objects in objects, so that viewers
/// unfold them; but where `a` is a column, `a.b` is a member of that name. The run must outlive it.
class RowShape {
 public:
  explicit RowShape(const table::RunView& run);

  /// The JSON schema of a row, with the units.
  std::string schema(const std::string& title) const;
  void append_row(std::string& text, std::size_t row) const;

 private:
  /// A member: of a column, or an object of others.
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
  /// A row is these texts, each followed by the number of its column, and `end_`.
  struct Piece {
    std::string text;
    const table::SeriesView* series;
  };
  std::vector<Piece> pieces_;
  std::string end_;
};

}  // namespace stepwire::mcap
