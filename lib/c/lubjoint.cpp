#include "lubjoint.h"

#include "array_rows.hpp"
#include "lubjoint/version.hpp"

lubjoint::c::LastMessage& lubjoint::c::last_message() noexcept {
  thread_local LastMessage message;
  return message;
}

const char* lubjoint_message(void) { return lubjoint::c::last_message().text(); }

const char* lubjoint_version(void) { return LUBJOINT_VERSION; }

const char* lubjoint_law_name(size_t i) {
  return i < lubjoint::named_film_laws.size() ? lubjoint::named_film_laws[i].data() : nullptr;
}
