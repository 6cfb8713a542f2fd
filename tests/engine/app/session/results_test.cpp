#include "engine/app/session/results.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "engine/base/io/file.hpp"

namespace stepwire::session {

TEST_CASE("the stub of Python is that of the declarations") {
  INFO("write it again: ./stepwire format --python > engine/app/python/stepwire/records.pyi");
  CHECK(io::read_file(STEPWIRE_SOURCE_DIR "/engine/app/python/stepwire/records.pyi") == results_stub());
}

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

}  // namespace stepwire::session
