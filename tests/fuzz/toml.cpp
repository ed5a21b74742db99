// toml++, compiled here so that it is instrumented like the rest.
#define TOML_HEADER_ONLY 0
#define TOML_IMPLEMENTATION
#include <toml++/toml.h>
