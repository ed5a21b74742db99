#!/bin/sh
# Installs what was built, and builds and runs another project with it.
#   consumer.sh SOURCE BUILD VERSION CMAKE_OPTIONS...    options: compilers and flags of the build
set -eu
source=$1
build=$2
version=$3
shift 3
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
fail() {
  echo "consumer.sh: $*" >&2
  exit 1
}
quiet() { "$@" >"$place/log" 2>&1 || { cat "$place/log" >&2 && fail "failed: $*"; }; }

quiet cmake --install "$build" --prefix "$place/first"
mv "$place/first" "$place/usr" # works wherever it is moved to
libraries=$(dirname "$(find "$place/usr" -name pkgconfig)")
export PKG_CONFIG_PATH="$libraries/pkgconfig"
configure() { cmake -G Ninja -S "$source/tests/consumer" -B "$place/build" "-DCMAKE_PREFIX_PATH=$place/usr" "$@"; }
quiet configure "-DLUBJOINT_WANTED=$version" "$@"
quiet cmake --build "$place/build"

export LD_LIBRARY_PATH="$libraries"
for program in force_law c_by_cmake c_by_pkg_config; do
  "$place/build/$program" >"$place/out" || fail "$program: $(cat "$place/out")"
  cat "$place/out"
  grep -q "^lubjoint $version, " "$place/out" || fail "$program is of another version than $version"
done
"$place/build/array_forces" || fail "array_forces: rows are not those of one state"
"$place/build/scene_file" "$place/usr/share/lubjoint/scenes/journal.toml" || fail "the scene was not run"
"$place/build/c_solvers" "$place/usr/share/lubjoint" || fail "c_solvers: solver, run or verification is not what it should be"

# No GPL library (GSL, GiNaC), and nothing else that the README does not name, is behind lib and what Python loads.
for file in "$place/build/force_law" "$place/build/array_forces" "$place/build/c_by_cmake" "$place/build/scene_file" "$libraries/liblubjoint_c.so" \
  "$libraries/liblubjoint_verify_c.so" "$libraries/liblubjoint_oracle_c.so" "$libraries/liblubjoint_simulate_c.so"; do
  [ -f "$file" ] || fail "$file is not there"
  needed=$(objdump -p "$file" | sed -n 's/^ *NEEDED *//p' |
    grep -vE '^(lib(c|m|gcc_s|stdc\+\+|tomlplusplus|fmt|lubjoint_c|asan|ubsan)\.so|ld-linux)' || true)
  [ -z "$needed" ] || fail "$(basename "$file") needs $needed"
done

# Another version is refused, in words.
if configure -DLUBJOINT_WANTED=99.0 "$@" >"$place/log" 2>&1; then fail "version 99.0 was found"; fi
grep -q "requested version \"99.0\"" "$place/log" || { cat "$place/log" >&2 && fail "the refusal names no version"; }
