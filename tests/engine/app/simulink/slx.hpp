#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <vector>

#include "engine/app/simulink/import.hpp"
#include "engine/base/table/table.hpp"
#include "tests/engine/base/table/scratch.hpp"
#include "tests/support/units/units.hpp"

namespace stepwire::simulink {

/// Parameters of a block, as its file has them.
using P = std::map<std::string, std::string>;

/// A block as files .slx have it. `inner` is more of its content: a mask, a <System>.
std::string block(const std::string& type, const std::string& name, int sid, const P& parameters = {},
                  const std::string& inner = "");
/// A block of a library.
std::string reference(const std::string& source, const std::string& name, int sid, const P& parameters = {});
/// A line from a port, "1#out:1", to others; with several it has branches.
std::string line(const std::string& from, const std::vector<std::string>& to, const std::string& name = "");

/// A model of R2012a to R2019b, in one file, or of R2020a and later, with a file for each system.
struct ModelText {
  std::string system;  ///< blocks and lines
  P solver{{"Solver", "ode4"}, {"FixedStep", "0.01"}, {"StopTime", "1"}};
  P callbacks{};
  std::string defaults{};  ///< <Block ..> of BlockParameterDefaults
  bool is_new = true;
  P states{}, messages{};  ///< parts of the configuration: initial states, and what is refused
};
testing::Entries entries_of(const ModelText& model);

/// A model that is imported into a folder.
class Imported {
 public:
  explicit Imported(const ModelText& model);
  explicit Imported(const testing::Entries& entries);

  /// Returns the text of the diagram.
  std::string text() const;
  std::string part(const std::string& file) const;
  /// Runs the diagram, and fails the test where that ends early.
  table::Table run() const;
  /// Returns why the run ends early.
  std::string fault() const;
  /// Returns the last value of a column of the run.
  double last(const std::string& column) const;
  /// Returns all sentences of a kind in lines "block: sentence".
  std::string notes(NoteKind kind) const;

  Scratch folder;
  ImportResult result;
};

/// Returns the last value of a source that is recorded as y.
double from_source(const std::string& source, const std::string& stop = "1");
/// Returns the last value behind a block with SID 9 that gets these sources, whose SIDs are 1, 2, ...
double through(const std::string& block, const std::vector<std::string>& sources,
               const std::string& stop = "1", int port = 1);
/// A constant as a source.
std::string number(int sid, const std::string& value);
/// A source of the time: a ramp of slope 1.
std::string time_source(int sid);

}  // namespace stepwire::simulink
