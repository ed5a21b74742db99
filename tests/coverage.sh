#!/bin/sh
# Line and branch coverage of lib and oracle by the tests (GCC, gcovr): a table by file on standard output, and with
# the source beside it in build/coverage/report/index.html.
#   tests/coverage.sh [CTEST OPTIONS]           e.g. -R "^force" for some tests only
# Environment: LUBJOINT_TARGETS  what to build (default: all), where some tests only are run
#              LUBJOINT_JOBS     parallel compilations (default: 1; each takes up to 1.5 GB)
# Exit status: that of the tests. A whole run takes about three times as long as ./lubjoint test from nothing.
set -eu
cd "$(dirname "$0")/.."
build=build/coverage
command -v gcovr >/dev/null || { echo 'tests/coverage.sh: gcovr is missing; Debian: apt-get install gcovr' >&2 && exit 2; }

cmake --preset coverage >/dev/null
# shellcheck disable=SC2086  # a list
cmake --build $build -j "${LUBJOINT_JOBS:-1}" --target ${LUBJOINT_TARGETS:-all} >&2
find $build -name '*.gcda' -delete # counts add up from run to run
status=0
# Not here: a full disk takes no counts, either, and a package does not depend on the library that counts.
ctest --test-dir $build --output-on-failure -E "^(Out of space: the message|Debian packages)" "$@" >&2 || status=$?

mkdir -p $build/report
# Branches that only an exception thrown by a called function takes are the compiler's, not ours.
gcovr --root . --object-directory $build --exclude-throw-branches --exclude-unreachable-branches \
  --filter lib/ --filter oracle/ --json $build/report/coverage.json --html-details $build/report/index.html \
  --print-summary $build/lib $build/oracle $build/tests $build/property_tests >$build/report/summary
gcovr --root . --add-tracefile $build/report/coverage.json --txt
cat $build/report/summary
exit $status
