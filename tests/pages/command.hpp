#pragma once

#include <set>
#include <string>
#include <vector>

/// Whether a test can run a command: one of the program that takes seconds and names real files. Those that
/// take minutes, and those of other programs, are only read.
bool is_run(const std::string& command);

/// Returns the fault of a command that is only read: an unknown verb, option, file or target; empty if it has
/// none.
std::string fault_of(const std::string& command);

/// Whether a piece of code is a command at all: it begins with the path of a program, or a well-known one.
bool is_command(const std::string& code);

/// The options of a text: --out, --set. Words of one dash and a letter are none.
std::set<std::string> options_in(const std::string& text);

/// The verbs of the program, as its own help lists them.
const std::vector<std::string>& verbs();

/// The help of a verb.
const std::string& help_of(const std::string& verb);
