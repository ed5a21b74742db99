// Numbers in messages.
#include "lubjoint/text/message.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "lubjoint/film/bearing.hpp"

namespace message_test {

using namespace lubjoint;

TEST_CASE("message: doubles stand in as few digits as say them, texts and other numbers as they are") {
  Message message;
  message << "a " << 0.043 << ", " << 1e-5 << ", " << 0.1 + 0.2 << ", " << -std::numeric_limits<double>::infinity()
          << ", " << 7 << ", " << 0.25L;
  CHECK(message.str() == "a 0.043, 1e-05, 0.30000000000000004, -inf, 7, 0.25");
  CHECK_THROWS_WITH(Bearing<double>(0.02, 0.01, 0.043), Catch::Contains("clearance is 0.043 m; allowed is less than"));
}

}  // namespace message_test
