/// What the functions of C interfaces share: exceptions become error numbers, and what they say is kept for who asks.
#pragma once

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>

#include "lubjoint/film/film_state.hpp"

namespace lubjoint::c {

/// No table of a compiled law is there yet for the bearing's L/D: who calls is to give one.
class NoTableError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What went wrong in this thread's last call; one object a library, thread_local.
class LastMessage {
 public:
  void say(const char* text) noexcept {
    std::size_t i = 0;
    for (; text[i] != '\0' && i + 1 < text_.size(); ++i) text_[i] = text[i];
    text_[i] = '\0';
  }
  const char* text() const noexcept { return text_.data(); }

 private:
  std::array<char, 1024> text_{};
};

/// Runs work. @returns 0, or the error number of what it threw, whose words go to the message
template <class Work>
int guarded(LastMessage& message, const Work& work) noexcept {
  try {
    work();
    return 0;
  } catch (const FilmDomainError& error) {
    message.say(error.what());
    return EDOM;
  } catch (const std::range_error& error) {
    message.say(error.what());
    return ERANGE;
  } catch (const NoTableError& error) {
    message.say(error.what());
    return ENOENT;
  } catch (const std::bad_alloc&) {
    message.say("no memory");
    return ENOMEM;
  } catch (const std::exception& error) {
    message.say(error.what());
    return EINVAL;
  }
}

/// @throws std::invalid_argument for a null pointer
template <class Pointer>
void require(const char* name, const Pointer& pointer) {
  if (pointer == nullptr) throw std::invalid_argument(std::string(name) + " is a null pointer");
}

/// A text that std::free gives back. @throws std::bad_alloc
inline char* copied(const std::string& text) {
  char* copy = static_cast<char*>(std::malloc(text.size() + 1));
  if (copy == nullptr) throw std::bad_alloc();
  std::memcpy(copy, text.c_str(), text.size() + 1);
  return copy;
}

}  // namespace lubjoint::c
