/// Version of the project. This is its one home: CMake, the C library, the program and the Python package read it here.
#pragma once

/// Raised when something that worked before works no longer (before 1.0: the second number is).
#define LUBJOINT_VERSION_MAJOR 0
/// Raised when something is added.
#define LUBJOINT_VERSION_MINOR 1
/// Raised when something is mended.
#define LUBJOINT_VERSION_PATCH 0

#define LUBJOINT_VERSION_TEXT_(number) #number
#define LUBJOINT_VERSION_JOIN_(major, minor, patch) \
  LUBJOINT_VERSION_TEXT_(major) "." LUBJOINT_VERSION_TEXT_(minor) "." LUBJOINT_VERSION_TEXT_(patch)
/// The three numbers as a string, "0.1.0".
#define LUBJOINT_VERSION \
  LUBJOINT_VERSION_JOIN_(LUBJOINT_VERSION_MAJOR, LUBJOINT_VERSION_MINOR, LUBJOINT_VERSION_PATCH)
