#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/resources.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire {

class Registry;

using io::EnvironmentError;
using yaml::Error;

#ifdef STEPWIRE_PACKAGE  // set by the target of the installed package: its folder share/stepwire
namespace detail {
inline const bool package_is_noted = (io::note_package(STEPWIRE_PACKAGE), true);
}
#endif

/// Names and texts of values, as in `--set`: {{"mass", "8 kg"}}.
using NamedTexts = std::vector<std::pair<std::string, std::string>>;

/// Signal of a model: an output or a state of a block, or a port of a part.
struct SignalInfo {
  std::string name;  ///< "cart.position"
  std::string unit;  ///< SI unit of its numbers: "m"; empty if it is unknown or 1
  std::size_t size = 1;
  std::size_t columns = 1;  ///< of a matrix, whose numbers are column by column
};

/// Input of the diagram itself, which the program that runs it writes.
struct InputInfo {
  std::string name, unit;
  std::size_t size = 1;
  std::string doc;
  std::size_t columns = 1;  ///< of a matrix, whose numbers are column by column
};

/// Parameter of the diagram or of one of its parts.
struct ParameterInfo {
  std::string name;  ///< "rig.mass"
  std::string text;  ///< value as it is written or set: "8 kg"
  std::string unit;  ///< SI unit; empty without one
  std::string doc;
};

/// Handle of a signal, or of an input, of one model. Made by Model.
struct SignalId {
  const void* model = nullptr;
  std::size_t index = 0;
};
struct InputId {
  const void* model = nullptr;
  std::size_t index = 0;
};

/// Loaded, checked and planned diagram. It is immutable; copies share it, also between threads.
class Model {
 public:
  /// Content of a model, for the library itself.
  struct Content;
  explicit Model(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

  const std::string& file() const;
  double step() const;       ///< [s]
  double stop() const;       ///< [s]
  std::size_t runs() const;  ///< points of its sweep; 1 without a sweep

  /// Returns the signals, sorted by name.
  const std::vector<SignalInfo>& signals() const;
  /// Returns a signal by its name in `record`. Throws Error with the nearest name for an unknown one.
  SignalId signal(const std::string& name) const;
  /// Returns the inputs in the order of the file.
  const std::vector<InputInfo>& inputs() const;
  /// Returns an input. Throws Error with the nearest name for an unknown one.
  InputId input(const std::string& name) const;
  std::vector<ParameterInfo> parameters() const;

  const Content& content() const { return *content_; }

 private:
  std::shared_ptr<const Content> content_;
};

/// Loads a diagram file whose blocks are in this registry. Throws Error with all faults, each with file, line
/// and column; EnvironmentError for system errors.
Model load(const std::string& path, Registry blocks, const NamedTexts& settings = {});

}  // namespace stepwire
