#include "tests/random/outcome.hpp"

#include <fmt/format.h>

#include <bit>

namespace stepwire::random {

namespace {

constexpr const char* file_name = "/random.yaml";

std::string column_difference(const table::Column& expected, const table::Column& other) {
  const std::size_t rows = std::min(expected.values.size(), other.values.size());
  for (std::size_t row = 0; row < rows; ++row)
    if (std::bit_cast<std::uint64_t>(expected.values[row]) != std::bit_cast<std::uint64_t>(other.values[row]))
      return fmt::format("{}, row {}: {} and not {}", expected.name, row, other.values[row],
                         expected.values[row]);
  if (expected.values.size() != other.values.size())
    return fmt::format("{}: {} rows and not {}", expected.name, other.values.size(), expected.values.size());
  return "";
}

std::string end_of(const run::RunResult& result) {
  return result.faults.empty() ? "to its end" : "into a fault";
}

}  // namespace

Loaded::Loaded(const Registry& registry, const Sketch& sketch, const std::string& folder,
               const std::vector<diagram::Setting>& settings)
    : loader_(std::make_unique<diagram::Loader>(registry)) {
  for (const auto& [file, part] : sketch.parts)
    loader_->add(yaml::parse_document(text_of(part), folder + "/" + file));
  loader_->add(yaml::parse_document(text_of(sketch), folder + file_name));
  job = std::make_unique<run::Job>(run::make_job(*loader_, folder + file_name, settings, {}, {}, 1));
}

Loaded::Loaded(const Registry& registry, const std::string& text, const std::string& folder)
    : loader_(std::make_unique<diagram::Loader>(registry)) {
  loader_->add(yaml::parse_document(text, folder + file_name));
  job = std::make_unique<run::Job>(run::make_job(*loader_, folder + file_name, {}, {}, {}, 1));
}

std::string difference(const run::RunResult& expected, const run::RunResult& other,
                       const OtherName& name_in_other) {
  if (end_of(expected) != end_of(other))
    return fmt::format("it runs {} and not {}", end_of(other), end_of(expected));
  if (expected.recordings.size() != other.recordings.size()) return "it has another number of tables";
  for (std::size_t r = 0; r < expected.recordings.size(); ++r)
    for (const table::Column& column : expected.recordings[r].table.columns) {
      const std::string name = name_in_other ? name_in_other(column.name) : column.name;
      const table::Column* found = other.recordings[r].table.find(name);
      if (!found) return fmt::format("there is no column {}", name);
      if (const std::string text = column_difference(column, *found); !text.empty()) return text;
    }
  return "";
}

}  // namespace stepwire::random
