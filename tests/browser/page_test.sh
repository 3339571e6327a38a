#!/bin/sh
# usage: page_test.sh SIGNORINI RUN...
# Makes the page of each run and looks at it in a headless Chromium, wide and narrow, light and dark: page_check.js
# clicks, filters and measures inside the page, and leaves its verdict in an attribute of the document.
set -eu

here=$(dirname -- "$(readlink -f -- "$0")")
signorini=$1
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

skip() {
  echo "skipped: $*"
  exit 77
}

# look PAGE OPTION...: the document as Chromium leaves it
look() {
  page=$1
  shift
  sandbox=
  [ "$(id -u)" -ne 0 ] || sandbox=--no-sandbox
  # shellcheck disable=SC2086  # one word or none
  timeout 120 chromium --headless $sandbox --disable-gpu --disable-dev-shm-usage --user-data-dir="$work/profile" \
    --virtual-time-budget=20000 "$@" --dump-dom "file://$page" 2>"$work/log"
}

command -v chromium >/dev/null || skip 'chromium is not installed'
command -v gnuplot >/dev/null || skip 'gnuplot is not installed'
echo '<p id=here>' >"$work/probe.html"
look "$work/probe.html" | grep -q 'id="here"' || skip "chromium does not start here: $(tail -n 1 "$work/log")"

failed=
for run; do
  name=$(basename "$run")
  cp -r "$run" "$work/$name"
  "$signorini" report "$work/$name" --format html >/dev/null
  # Ears before the page's own script, questions after it.
  awk -v ears="$here/page_ears.js" -v check="$here/page_check.js" '
    function insert(file,    line) {
      print "<script>"
      while ((getline line < file) > 0) print line
      print "</script>"
    }
    /^<\/body>/ { insert(check) }
    { print }
    /^<body>/ { insert(ears) }' "$work/$name/report.html" >"$work/$name/checked.html"
  for window in 1400,1000 500,900; do
    for scheme in 0 1; do # dark, light
      verdict=$(look "$work/$name/checked.html" --window-size=$window \
        --blink-settings=preferredColorScheme=$scheme | sed -n 's/.*data-verdict="\([^"]*\)".*/\1/p' | head -n 1)
      echo "$name, window $window, colour scheme $scheme: ${verdict:-no verdict}"
      case $verdict in passed*) ;; *) failed=1 ;; esac
    done
  done
done
[ -z "$failed" ]
