#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/engine/base/table/scratch.hpp"

/// A program that uses `stepwire mcp` over pipes, with a folder of its own.
class Client {
 public:
  /// Starts the server, sends messages after the handshake, and returns the answers but that of the
  /// handshake.
  std::vector<nlohmann::json> exchange(const std::vector<std::string>& messages,
                                       const std::vector<std::string>& options = {}) const;
  /// Calls a tool and returns its result. Fails the test for a protocol error.
  nlohmann::json call(const std::string& tool, nlohmann::json arguments) const;
  /// Calls a tool with the text of a diagram and returns the structured content.
  nlohmann::json on_text(const std::string& tool, const std::string& text,
                         nlohmann::json more = nlohmann::json::object()) const;
  /// Runs a text and returns the values of its claims by their `that`. Fails the test for a claim that fails.
  nlohmann::json values(const std::string& text, nlohmann::json more = nlohmann::json::object()) const;

  const Scratch& folder() const { return folder_; }

 private:
  Scratch folder_;
};

/// A head with step, stop and solver, in front of a text.
std::string diagram(const std::string& step, const std::string& stop, const std::string& rest,
                    const std::string& solver = "rk4");
