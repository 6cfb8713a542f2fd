#pragma once

#include <string>

/// How many processes work in a folder; those that end within two seconds are not counted, nor is one that
/// nobody waits for yet.
int processes_in(const std::string& folder);
