#!/bin/sh
# guide_test.sh TREE FOLDER BUILD: docs/adding-a-method.md, followed literally in a scratch copy of the tree, brings its method
# into the table of the catalogue in under ten commands and touches nothing of the tree but two lines; docs/adding-a-scene.md holds too.
set -eu

tree=$1
folder=$2
build=$3
copy=$folder/tree

fail() {
  echo "failed: $*" >&2
  exit 1
}

# What is tracked, or would be; all but builds and results where there is no git.
copy_tree() {
  rm -rf "$folder"
  mkdir -p "$copy"
  if git -C "$tree" rev-parse --is-inside-work-tree >/dev/null 2>&1; then
    git -C "$tree" ls-files --cached --others --exclude-standard >"$folder/files"
  else
    (cd "$tree" && find . -type f ! -path './build/*' ! -path './.git' ! -path './.git/*' ! -path './results/local*') >"$folder/files"
  fi
  # A file that is tracked and deleted is no part of the tree.
  (cd "$tree" && while IFS= read -r file; do [ ! -e "$file" ] || printf '%s\n' "$file"; done) <"$folder/files" >"$folder/present"
  tar -C "$tree" -cf - -T "$folder/present" | tar -C "$copy" -xf -
}

# Every file outside builds and results with its hash.
hashes() { (cd "$copy" && find . -type f ! -path './build/*' ! -path './results/*' -exec sha256sum {} + | LC_ALL=C sort -k 2); }

# follow PAGE: its commands, one after the other; their number is in $count.
follow() {
  awk '/^```sh$/ { on = 1; next } /^```$/ { on = 0 } on' "$copy/docs/$1.md" >"$folder/commands"
  count=$(wc -l <"$folder/commands")
  [ "$count" -gt 0 ] || fail "$1 has no commands"
  while IFS= read -r command; do
    echo "\$ $command"
    in_copy "$command" >"$folder/log" 2>&1 || { tail -n 100 "$folder/log" && fail "$command"; }
  done <"$folder/commands"
}

# A build begins from what is built already where the copy can stand in the tree's own place, in a name space of its
# own; elsewhere it begins anew, which takes its time.
begin_build() {
  [ "$build" = "$tree/build/release" ] && unshare --mount true 2>/dev/null || return 0
  mkdir -p "$copy/build/release"
  tar -C "$build" --exclude=./tests/guide/scratch --exclude=./Testing -cf - . | tar -C "$copy/build/release" -xf -
  stands_in=yes
}

in_copy() {
  if [ -n "$stands_in" ]; then
    unshare --mount sh -c 'mount --bind "$1" "$2" && cd "$2" && sh -c "$3"' sh "$copy" "$tree" "$1" </dev/null
  else
    (cd "$copy" && sh -c "$1") </dev/null
  fi
}

stands_in=
copy_tree
begin_build
hashes >"$folder/before"
follow adding-a-method
[ "$count" -lt 10 ] || fail "the page needs $count commands"

table=$copy/results/local-my-method/table.md
grep -q '^| sdof-far-stop .*| my-method\[harmonics=10\] .*| converged ' "$table" || fail 'the table lacks the method'
cases=$(wc -l <"$copy/results/local-my-method/records.jsonl")
[ "$cases" -ge 2 ] || fail "the run has $cases cases"
grep -q "^| my-method *| *$cases *|" "$table" || fail 'the summary lacks the method'
hashes >"$folder/after"
changed=$(diff "$folder/before" "$folder/after" | sed -n 's/^[<>] [0-9a-f]*  //p' | LC_ALL=C sort -u | grep -v -e '^\./methods/my_method/' -e '^\./tests/methods/my_method/' || true)
[ "$changed" = ./methods/catalogue.cpp ] || fail "other files changed: $changed"
lines=$(diff "$tree/methods/catalogue.cpp" "$copy/methods/catalogue.cpp" | grep -c '^[<>]')
[ "$lines" -eq 2 ] || fail "$lines lines of the catalogue changed"
if command -v clang-format >/dev/null; then
  (cd "$copy" && clang-format --dry-run -Werror methods/catalogue.cpp methods/my_method/*.?pp tests/methods/my_method/*.cpp) || fail 'the format of what was written'
fi
echo "a method takes $count commands"

follow adding-a-scene
[ -s "$copy/results/references/my-scene.json" ] || fail 'the scene of the catalogue has no orbits'
echo 'both pages hold'
