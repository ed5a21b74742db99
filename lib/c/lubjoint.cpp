#include "lubjoint.h"

#include <array>

#include "array_rows.hpp"
#include "lubjoint/version.hpp"

namespace {
thread_local std::array<char, 512> message{};
}

void lubjoint::c::say(const char* text) noexcept {
  std::size_t i = 0;
  for (; text[i] != '\0' && i + 1 < message.size(); ++i) message[i] = text[i];
  message[i] = '\0';
}

const char* lubjoint_message(void) { return message.data(); }

const char* lubjoint_version(void) { return LUBJOINT_VERSION; }

const char* lubjoint_law_name(size_t i) {
  return i < lubjoint::named_film_laws.size() ? lubjoint::named_film_laws[i].data() : nullptr;
}
