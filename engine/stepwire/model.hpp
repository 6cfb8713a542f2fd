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

#ifdef STEPWIRE_PACKAGE  // by the target of the installed package: its folder share/stepwire
namespace detail {
inline const bool package_is_noted = (io::note_package(STEPWIRE_PACKAGE), true);
}
#endif

/// Names and texts of values, as `--set` has them: {{"mass", "8 kg"}}.
using NamedTexts = std::vector<std::pair<std::string, std::string>>;

/// A signal of one model: an output or a state of a block, or a port of a part.
struct SignalInfo {
  std::string name;  ///< "cart.position"
  std::string unit;  ///< of its numbers, which are SI: "m"; empty where none is known or it has none
  std::size_t size = 1;
  std::size_t columns = 1;  ///< of a matrix, whose numbers are column by column
};

/// An input of the diagram itself, which whoever runs it writes.
struct InputInfo {
  std::string name, unit;
  std::size_t size = 1;
  std::string doc;
  std::size_t columns = 1;  ///< of a matrix, whose numbers are column by column
};

/// A parameter of the diagram or of one of its parts.
struct ParameterInfo {
  std::string name;  ///< "rig.mass"
  std::string text;  ///< its value as it is written or set: "8 kg"
  std::string unit;  ///< SI; empty where it has none
  std::string doc;
};

/// How a signal, or an input, of one model is named in a run. Made by Model.
struct SignalId {
  const void* model = nullptr;
  std::size_t index = 0;
};
struct InputId {
  const void* model = nullptr;
  std::size_t index = 0;
};

/// A diagram that is loaded, checked and planned. Never changes; copies share it, also from several threads.
class Model {
 public:
  /// What a model holds; for the library itself.
  struct Content;
  explicit Model(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

  const std::string& file() const;
  double step() const;       ///< [s]
  double stop() const;       ///< [s]
  std::size_t runs() const;  ///< points of its sweep; 1 without

  /// By name, in alphabetical order.
  const std::vector<SignalInfo>& signals() const;
  /// As `record` names signals. Throws Error with the nearest name where there is none.
  SignalId signal(const std::string& name) const;
  /// In the order of the file.
  const std::vector<InputInfo>& inputs() const;
  /// Throws Error with the nearest name where there is none.
  InputId input(const std::string& name) const;
  std::vector<ParameterInfo> parameters() const;

  const Content& content() const { return *content_; }

 private:
  std::shared_ptr<const Content> content_;
};

/// Loads a diagram file whose blocks are of this registry. Throws Error with all that is wrong, each with
/// file, line and column; EnvironmentError where the system refuses.
Model load(const std::string& path, Registry blocks, const NamedTexts& settings = {});

}  // namespace stepwire
