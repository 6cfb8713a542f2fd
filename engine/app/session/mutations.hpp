#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/session/loaded_model.hpp"

namespace stepwire::session {

/// Wrong version of a diagram. Alternatives are tried in order until the file accepts one.
struct Mutation {
  enum class Kind { parameter, wire, drawn };

  /// One of its versions: a setting, another document, or another section `figure`.
  struct Version {
    std::string text;  ///< "2*(0.4 s)", or the name of the other signal
    std::optional<diagram::Setting> setting{};
    std::shared_ptr<const yaml::Document> document{};
    std::optional<yaml::Node> figure{};
  };

  Kind kind = Kind::parameter;
  std::string what;  ///< "parameter tau", "wire lag.u", "figure y"
  std::string old;   ///< Value, source or signal as written.
  std::vector<Version> versions{};
};

/// Returns "parameter", "wire" or "drawn".
const char* kind_name(Mutation::Kind kind);

/// Wrong versions of a file.
struct Mutations {
  std::vector<Mutation> all{};
  std::vector<std::string> left_out{};  ///< parameters without any, with the reason: "mode: it is swept"
};

/// Returns the wrong versions of a file. Each number of a parameter, also of a part, is doubled, halved and
/// negated. Each wire and each drawn signal comes from another signal of the same unit.
Mutations mutations_of(const LoadedModel& model);

}  // namespace stepwire::session
