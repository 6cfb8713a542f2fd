#pragma once

#include "engine/app/studio/http/gate.hpp"
#include "engine/app/studio/http/site.hpp"

namespace stepwire::http {

/// An answer of this status without a body.
Answer empty_answer(int status);

/// What the decision of the gate gives, of anything but a socket.
Answer reply(const Request& request, const Decision& decision, const Key& key, Site& site);

}  // namespace stepwire::http
