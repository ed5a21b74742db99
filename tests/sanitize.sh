#!/bin/sh
# The tests under the address, leak and undefined-behaviour sanitizers (Clang, preset asan).
#   tests/sanitize.sh [CTEST OPTIONS]          e.g. -R "^verify" for some tests only
# Environment: LUBJOINT_TEST_FILES  regular expression: tests/FILE_test.cpp that are built, in a folder of their own
#              LUBJOINT_TARGETS     what to build (default: all)
#              LUBJOINT_JOBS        parallel compilations (default: 1; each takes up to 1.5 GB)
# Exit status: that of the tests; 77: no Clang here, nothing done.
set -eu
cd "$(dirname "$0")/.."
build=build/asan${LUBJOINT_TEST_FILES:+-some}
if ! command -v clang++ >/dev/null ||
  ! echo 'int main() {}' | clang++ -x c++ -fsanitize=address,undefined - -o /dev/null 2>/dev/null; then
  echo 'tests/sanitize.sh: skipped: no Clang with sanitizers here (Debian: clang libclang-rt-14-dev)' >&2
  exit 77
fi
cmake --preset asan -B $build -DLUBJOINT_TEST_FILES="${LUBJOINT_TEST_FILES-}" >/dev/null
# shellcheck disable=SC2086  # a list
cmake --build $build -j "${LUBJOINT_JOBS:-1}" --target ${LUBJOINT_TARGETS:-all} >&2
export ASAN_OPTIONS=detect_leaks=1:detect_stack_use_after_return=1 UBSAN_OPTIONS=print_stacktrace=1
export LSAN_OPTIONS=print_suppressions=0 # to the standard error of programs of which nothing else is expected there
ctest --test-dir $build --output-on-failure "$@"
