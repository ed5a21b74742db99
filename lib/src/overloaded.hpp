#pragma once

namespace lubjoint {

/// Functions as one, for std::visit: an alternative that none of them takes does not compile.
template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace lubjoint
