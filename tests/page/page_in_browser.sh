#!/bin/sh
# Opens the report in headless Chromium and uses it: wide and narrow, light and dark, with less motion.
#   page_in_browser.sh LUBJOINT [FOLDER]    FOLDER keeps the report and pictures of it for people to look at
set -eu
lubjoint=$1
here=$(cd -- "$(dirname -- "$0")" && pwd)
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
if [ -z "$browser" ]; then
  echo 'skipped: chromium is not installed'
  exit 77
fi
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
"$lubjoint" reproduce --out "$place" --data "$here/invented-data" >/dev/null 2>"$place/log" || {
  cat "$place/log" >&2
  exit 1
}

# The report with a witness of its complaints before everything else and the test after it.
{
  sed '/<meta charset/q' "$place/report.html"
  cat <<'HEAD'
<script>
window.complaints = [];
addEventListener('error', (event) => complaints.push(event.message));
addEventListener('unhandledrejection', (event) => complaints.push(String(event.reason)));
for (const kind of ['error', 'warn']) console[kind] = (...words) => complaints.push(words.join(' '));
</script>
HEAD
  sed '1,/<meta charset/d' "$place/report.html" | sed '/^<\/body>/d; /^<\/html>/d'
  printf '<script>\n'
  cat "$here/self_test.js"
  printf '</script>\n</body>\n</html>\n'
} >"$place/tested.html"

# Chromium's window is never narrower than 500 px; a frame is.
frame() { # WIDTH HEIGHT PAGE
  cat <<PAGE
<!DOCTYPE html><meta charset="utf-8"><style>body { margin: 0 }</style>
<iframe src="$3" width="$1" height="$2" style="border: 0; display: block"></iframe><pre id="result">no answer</pre>
<script>
addEventListener('message', ({data}) => {
  document.getElementById('result').textContent = data.settings + ': ' + data.checks + ' checks, ' +
    data.failures.length + ' failures' + data.failures.slice(0, 40).map((words) => '\\n  ' + words).join('');
});
</script>
PAGE
}

chromium_on() { # OPTIONS… ADDRESS
  profile=$(mktemp -d "$place/profile.XXXXXX")
  timeout 150 "$browser" --headless --no-sandbox --disable-gpu --disable-quic --no-first-run --hide-scrollbars \
    --disable-background-networking --disable-component-update --disable-sync --disable-extensions \
    --user-data-dir="$profile" "$@" 2>"$place/browser.log"
}

status=0
test_at() { # WIDTH [OPTIONS…]
  width=$1
  shift
  frame "$width" 900 tested.html >"$place/frame.html"
  chromium_on "$@" --window-size=1400,1000 --virtual-time-budget=60000 --dump-dom "file://$place/frame.html" |
    awk -v RS='</pre>' 'sub(/.*<pre id="result">/, "") { print; exit }' >"$place/answer"
  cat "$place/answer"
  grep -q ', 0 failures' "$place/answer" || status=1
}
test_at 1280
test_at 1280 --force-dark-mode --force-prefers-reduced-motion
test_at 400
test_at 400 --force-dark-mode

if [ $# -gt 1 ]; then
  mkdir -p "$2"
  cp "$place/report.html" "$2"
  for width in 1280 400; do
    frame "$width" 15500 report.html >"$place/frame.html"
    for look in light dark; do
      option=--hide-scrollbars
      [ "$look" = light ] || option=--force-dark-mode
      chromium_on "$option" --window-size="$((width > 500 ? width : 500)),15500" --virtual-time-budget=3000 \
        --screenshot="$place/picture.png" "file://$place/frame.html" || status=1
      cp "$place/picture.png" "$2/report-$width-$look.png"
    done
  done
  chromium_on --virtual-time-budget=3000 --no-pdf-header-footer --print-to-pdf="$2/report.pdf" \
    "file://$2/report.html" || status=1
fi
exit "$status"
