// toml++, compiled here so that it is instrumented like the rest. Without its assertions, as Debian's library is:
// version 3.3 asserts that a table's header begins with a name, and then has an error for those that do not.
#define TOML_ASSERT(condition) static_assert(true)
#define TOML_IMPLEMENTATION
#include <toml++/toml.h>
