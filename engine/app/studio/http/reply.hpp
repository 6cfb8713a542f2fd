#pragma once

#include "engine/app/studio/http/gate.hpp"
#include "engine/app/studio/http/site.hpp"

namespace stepwire::http {

/// Returns an answer with this status and no body.
Answer empty_answer(int status);

/// Answers a request according to the gate's decision; sockets are handled elsewhere.
Answer reply(const Request& request, const Decision& decision, const Key& key, Site& site);

}  // namespace stepwire::http
