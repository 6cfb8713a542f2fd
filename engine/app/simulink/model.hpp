#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace stepwire::simulink {

/// Parameters by name, as MATLAB texts.
using Texts = std::map<std::string, std::string, std::less<>>;

struct System;

/// A block of a model as its file has it.
struct Block {
  std::string type;  ///< BlockType: "Gain".
  std::string name;  ///< As people see it, on one line.
  std::string sid;   ///< Identifier in its model.
  Texts texts;       ///< Parameters in the file; those with default values are absent.
  std::vector<std::pair<std::string, std::string>> mask;  ///< Parameters of its mask, in order.
  std::string mask_code;                                  ///< Initialization of its mask.
  std::map<int, std::string> output_names;                ///< Names of signals by the port, from 1.
  std::unique_ptr<System> system;  ///< Content of a subsystem; nullptr for other blocks.
};

/// An end of a line: a block and its port.
struct LineEnd {
  std::string sid;
  std::string port;  ///< "out:1", "in:2", "enable", "trigger", "ifaction", "state"
};

/// A line with its branches.
struct Line {
  LineEnd source;
  std::vector<LineEnd> sinks;
  std::string name;  ///< of the signal; may be empty
};

/// A system of blocks and lines.
struct System {
  std::vector<Block> blocks;
  std::vector<Line> lines;
  std::vector<std::string> annotations;  ///< texts, without markup
};

/// A model as its file has it.
struct Model {
  std::string name;                                    ///< of the file, without its ending
  Texts texts;                                         ///< of the model itself: its callbacks among them
  Texts solver;                                        ///< of the active configuration
  std::map<std::string, Texts, std::less<>> defaults;  ///< of each type of block
  System root;
  std::vector<std::string> notes;  ///< sentences on parts of the file that were not read
};

}  // namespace stepwire::simulink
