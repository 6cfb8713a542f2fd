#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/base/json/json.hpp"

namespace stepwire::result {

struct RecordType;

/// Type of a value in a result.
struct ValueType {
  enum class Kind {
    flag,
    count,
    finite,  ///< number that is never null
    number,  ///< null in JSON if it is not finite
    text,
    complex,  ///< [re, im] in JSON
    pair,     ///< two numbers
    matrix,   ///< list of rows
    list,
    map,  ///< values by name
    record,
    any  ///< any JSON; the documentation of the field describes it
  };

  Kind kind = Kind::any;
  bool optional = false;                    ///< true: null in JSON without a value
  const RecordType& (*record)() = nullptr;  ///< type of a record
  std::vector<ValueType> item{};            ///< one type: that of the items of a list or a map
};

/// Named value of a record.
struct FieldType {
  std::string name, doc;
  std::string unit;  ///< empty: none, or given by another field
  ValueType type;
  bool omitted = false;                            ///< true: no member of the JSON object without a value
  bool hidden = false;                             ///< true: for programs, in no file
  std::vector<std::string> choices{};              ///< all words of a text; empty: any text
  std::function<json::Json(const void*)> value{};  ///< value of the field of an object
};

/// Fields of a struct in the order of the JSON object.
struct RecordType {
  std::string name;  ///< name of the type in Python and TypeScript
  std::string doc;
  std::vector<FieldType> fields;

  /// Returns the fields of an object; with `hidden` also those that are in no file.
  json::Json json_of(const void* object, bool hidden = false) const;
};

/// Describes a type in words: "list of FittedParameter", "number or null".
std::string type_text(const ValueType& type);

/// Returns a record and all records that its fields contain, each once, the contained ones first.
std::vector<const RecordType*> records_of(const std::vector<const RecordType*>& roots);

/// Returns the records with their fields as JSON, for programs that make classes of them.
json::Json description_of(const std::vector<const RecordType*>& roots);
/// Returns the interfaces of TypeScript of these records and of all records that they contain.
std::string typescript_of(const std::vector<const RecordType*>& roots);
/// Returns the classes of a Python stub in the same way.
std::string python_stub_of(const std::vector<const RecordType*>& roots);
/// Returns the name of a field as an attribute in Python: "p99_9" for "p99.9".
std::string attribute_of(const std::string& field);

}  // namespace stepwire::result
