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
for command in 'stress --quick' 'bench --quick' "sweep $scene --vary joints[0].clearance=1e-4:2e-4:2" "model-error $scene"; do
  # shellcheck disable=SC2086  # words
  refused 'allowed is a folder that can be written to' $command --out new
done
refused 'allowed is a folder that can be written to' verify --law short_full --states-out states.csv
[ "$(ls -A .)" = "$(printf 'filler\njournal.csv')" ] || fail "left on the full disk: $(ls -A .)"
rm filler journal.csv

# What a campaign has done is kept when its results have no room, and taken up when they have.
changed='joints[0].clearance=1e-4:2e-4:3'
whole=$("$program" sweep "$scene" --duration 1e-3 --vary "$changed" 2>/dev/null) || fail 'no sweep'
mount -o remount,size=8k "$4"
dd if=/dev/zero of=filler bs=4k count=1 2>/dev/null
refused 'No space left on device' sweep "$scene" --duration 1e-3 --vary "$changed" --out .
rm filler
mount -o remount,size=16k "$4"
"$program" sweep "$scene" --duration 1e-3 --vary "$changed" --out . --json >summary 2>/dev/null || fail 'no sweep with room'
grep -q '"run_now": 0,' summary || fail 'points ran again'
[ "$(cat journal-sweep.csv)" = "$whole" ] || fail 'a sweep that met a full disk ends otherwise'
rm -- *
mount -o remount,size=16k "$4"
stress='stress --quick --case journal-step-limit --law short_half --integrator dopri5 --out .'
# shellcheck disable=SC2086  # words
refused 'No space left on device' $stress
row=$(tail -n 1 stress.part)
mount -o remount,size=4m "$4"
# shellcheck disable=SC2086  # words
"$program" $stress >/dev/null 2>&1 || fail 'no stress with room'
[ "$(tail -n 1 stress.csv)" = "$row" ] || fail 'a cell ran again'
[ "$(ls -A . | tr '\n' ' ')" = 'stress.csv stress.png stress.svg ' ] || fail "left after stress: $(ls -A .)"

mount -o remount,ro "$4"
for command in "simulate $scene" reproduce 'stress --quick' 'bench --quick' "model-error $scene" \
  "sweep $scene --vary joints[0].clearance=1e-4:2e-4:2"; do
  # shellcheck disable=SC2086  # words
  refused 'Read-only file system; allowed is' $command --out below/it
done
refused 'Read-only file system; allowed is' verify --law short_full --states-out states.csv
