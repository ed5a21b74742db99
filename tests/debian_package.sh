#!/bin/sh
# Makes the Debian packages of what was built, and uses what is in them.
#   debian_package.sh BUILD VERSION
set -eu
build=$1
version=$2
for tool in dpkg-deb dpkg-shlibdeps strip; do
  command -v $tool >/dev/null || { echo "skipped: $tool is not installed" && exit 77; }
done
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
fail() {
  echo "debian_package.sh: $*" >&2
  exit 1
}

# gzip: a third of xz's time
(cd "$build" && cpack -G DEB -B "$place" -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip) >"$place/log" 2>&1 || { cat "$place/log" >&2 && fail "cpack failed"; }
mkdir "$place/root"
package() { # its file: one, of this name and version
  set -- "$place/$1"_"$version"_*.deb
  [ $# = 1 ] && [ -f "$1" ] || fail "no one package $1"
  echo "$1"
}
tool=$(package lubjoint)
library=$(package liblubjoint-c0)
solvers=$(package liblubjoint-solvers-c0)
headers=$(package liblubjoint-dev)
holds() { # a file whose path ends thus
  dpkg-deb -c "$1" | awk '{print $6}' | grep -qE "$2\$" || fail "$(basename "$1") holds no $2"
}
depends() {
  dpkg-deb -f "$1" Depends | tr ',' '\n' | grep -qE "^ *$2" || fail "$(basename "$1") does not depend on $2"
}
for program in lubjoint lubjoint-paper lubjoint-scenes lubjoint-verify lubjoint-measure; do holds "$tool" "./usr/bin/$program"; done
holds "$tool" ./usr/share/lubjoint/scenes/journal.toml
holds "$tool" ./usr/share/lubjoint/golden/manifest.json
holds "$tool" ./usr/share/lubjoint/literature/raimondi-boyd.csv
holds "$library" "./usr/lib/.*liblubjoint_c.so.$version"
for part in oracle simulate verify; do
  holds "$solvers" "./usr/lib/.*liblubjoint_${part}_c.so.$version"
  holds "$headers" "./usr/lib/.*/?liblubjoint_${part}_c.so"
  holds "$headers" "./usr/include/lubjoint_$part.h"
done
holds "$headers" ./usr/include/lubjoint/film/law.hpp
holds "$headers" ./usr/include/lubjoint.h
holds "$headers" "./usr/lib/.*cmake/lubjoint/lubjointConfig.cmake"
holds "$headers" "./usr/lib/.*pkgconfig/lubjoint-c.pc"
holds "$headers" "./usr/lib/.*/?liblubjoint_c.so"
depends "$tool" libc6
depends "$tool" libgsl
depends "$library" 'libstdc\+\+6'
depends "$headers" "liblubjoint-c0 \\(= $version\\)"
depends "$headers" "liblubjoint-solvers-c0 \\(= $version\\)"
depends "$headers" libeigen3-dev
depends "$headers" libboost-dev
for file in "$library" "$solvers"; do
  if dpkg-deb -f "$file" Depends | grep -qE 'gsl|ginac|flint'; then fail "$file depends on a GPL library"; fi
done

# No file twice, none outside /usr.
for file in "$tool" "$library" "$solvers" "$headers"; do dpkg-deb -c "$file" | awk '!/^d/ {print $6}'; done | sort >"$place/files"
[ -z "$(uniq -d "$place/files")" ] || fail "in two packages: $(uniq -d "$place/files")"
if grep -v '^\./usr/' "$place/files"; then fail "files outside of /usr"; fi

# Unpacked anywhere, the program runs and finds its data.
for file in "$tool" "$library" "$solvers" "$headers"; do dpkg-deb -x "$file" "$place/root"; done
program=$place/root/usr/bin/lubjoint
cd "$place"
[ "$("$program" --version)" = "$version" ] || fail "lubjoint --version says $("$program" --version)"
"$program" simulate root/usr/share/lubjoint/scenes/journal.toml --json 2>err | grep -q '"status": "finished"' ||
  fail "lubjoint simulate did not finish"
"$program" --help | grep -q '^  golden ' && "$program" golden --check --every 1000
if grep -qF -e "$build" "$program"; then fail "the program contains the path of the folder that it was built in"; fi
