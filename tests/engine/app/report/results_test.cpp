#include "engine/app/report/results.hpp"

#include <catch2/catch.hpp>
#include <set>

namespace stepwire::report {

TEST_CASE("each field of a result has a meaning and a name of its own in Python") {
  std::vector<const result::RecordType*> roots;
  for (const JobResult& one : job_results()) roots.push_back(&one.type);
  std::set<std::string> names;
  for (const result::RecordType* record : result::records_of(roots)) {
    INFO(record->name);
    CHECK(names.insert(record->name).second);
    CHECK_FALSE(record->doc.empty());
    std::set<std::string> attributes;
    for (const result::FieldType& field : record->fields) {
      INFO(field.name);
      CHECK_FALSE(field.doc.empty());
      CHECK(attributes.insert(result::attribute_of(field.name)).second);
    }
  }
}

}  // namespace stepwire::report
