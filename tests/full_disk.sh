#!/bin/sh
# Writes to file systems that are full and that are read-only, of its own.   full_disk.sh PROGRAM SCENE
set -eu
if [ "${3-}" != mounted ]; then
  unshare --user --map-root-user --mount true 2>/dev/null || { echo 'skipped: no file system can be mounted' && exit 77; }
  place=$(mktemp -d)
  trap 'rmdir "$place"' EXIT
  unshare --user --map-root-user --mount "$0" "$1" "$2" mounted "$place"
  exit
fi
program=$1
scene=$2
cd "$4"
fail() {
  echo "full_disk.sh: $*" >&2
  exit 1
}
refused() { # WHY COMMAND...: exit 2, one line on standard error with the reason, nothing on standard output
  why=$1
  shift
  status=0
  said=$("$program" "$@" 2>&1 >/dev/null) || status=$?
  [ $status = 2 ] || fail "$* ended with $status: $said"
  case $said in *"$why"*) ;; *) fail "$* does not say \"$why\": $said" ;; esac
}

mount -t tmpfs -o size=64k lubjoint "$4"
cd "$4"
refused 'journal.csv" can'\''t be written: No space left on device' simulate "$scene" --out .
[ -z "$(ls -A .)" ] || fail "left on the full disk: $(ls -A .)"
echo kept >journal.csv
refused 'No space left on device' simulate "$scene" --out .
[ "$(ls -A .)" = journal.csv ] && [ "$(cat journal.csv)" = kept ] || fail 'the old file is gone'
dd if=/dev/zero of=filler bs=4k 2>/dev/null || true # not a byte left: found before anything is computed
refused 'allowed is a folder that can be written to' simulate "$scene" --out new
refused 'allowed is a folder that can be written to' reproduce --out .
rm filler
mount -o remount,ro "$4"
refused 'Read-only file system; allowed is' simulate "$scene" --out .
refused 'Read-only file system; allowed is' reproduce --out below/it
