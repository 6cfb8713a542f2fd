#pragma once

#include <string>

/// Returns the number of processes that work in a folder. Processes that end within two seconds are not
/// counted, nor are those that have ended and were not waited for.
int processes_in(const std::string& folder);
