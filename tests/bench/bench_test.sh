#!/bin/sh
# Tests of ./bench: what it asks of the tools around it. usage: bench_test.sh PATH-OF-BENCH
#
# A copy of the script runs in a folder whose name has a space, with stand-ins first in PATH. Each stand-in appends
# its name and arguments to $calls, so that a test can tell what was asked, and with which words; a line in one write,
# since two may run at once.
set -eu

bench_under_test=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tree="$work/a tree"
tools=$work/tools
export calls="$work/calls" packages="$work/packages" fail="$work/fail" ninja_steps="$work/steps" tools
mkdir -p "$tree/part" "$tools"
cp "$bench_under_test" "$tree/bench"
chmod +x "$tree/bench"
failures=0

stand_in() { # NAME, its further behaviour on stdin
  {
    # shellcheck disable=SC2016  # expanded by the stand-in
    printf '#!/bin/sh\nline=$(printf %s; printf " <%%s>" "$@")\nprintf "%%s\\n" "$line" >>"$calls"\n' "$1"
    cat
  } >"$tools/$1"
  chmod +x "$tools/$1"
}

# Package states come from $packages; `all` there means everything is installed.
stand_in dpkg-query <<'END'
for word; do
  case $word in
    -*) ;;
    *) if grep -qxF all "$packages" || grep -qxF "$word" "$packages"; then echo "$word/installed"; else echo "$word/config-files"; fi ;;
  esac
done
END
# An install succeeds only after an update, as on a new machine; apt-get names may be made to fail altogether.
stand_in apt-get <<'END'
[ ! -e "$fail.apt-get" ] || exit 100
case " $* " in
  *' update '*) touch "$packages.updated" ;;
  *) [ -e "$packages.updated" ] || { echo 'E: Unable to locate package' && exit 100; } ;;
esac
END
stand_in sudo <<'END'
[ -e "$packages.sudo" ] || exit 1
[ "$1" = -n ] && shift
exec "$@"
END
stand_in id <<'END'
cat "$packages.id"
END
stand_in cmake <<'END'
[ "$1" != -S ] || {
  build=$2/build/$4
  mkdir -p "$build/harness"
  cat >"$build/build.ninja" <<MANIFEST
build CMakeFiles/facts facts.cpp | \${cmake_ninja_workdir}CMakeFiles/facts \${cmake_ninja_workdir}facts.cpp: CUSTOM_COMMAND a || b
  COMMAND = write facts.cpp
build CMakeFiles/edit_cache.util: CUSTOM_COMMAND
build pages.txt: CUSTOM_COMMAND harness/signorini
MANIFEST
  printf '%s\n' "CMAKE_HOME_DIRECTORY:INTERNAL=$2" "CMAKE_MAKE_PROGRAM:FILEPATH=$tools/ninja" >"$build/CMakeCache.txt"
}
[ ! -e "$fail.$1" ] || { echo 'the reason it failed' && exit 1; }
END
# The lines of $ninja_steps are the steps that are left; each takes the seconds of $ninja_steps.pace. Told to end, it leaves a word.
stand_in ninja <<'END'
case " $* " in
  *' build.ninja '*) exit 0 ;;
  *' -n '*) [ ! -e "$ninja_steps" ] || cat "$ninja_steps"; exit 0 ;;
esac
trap 'echo ended >"$ninja_steps.ended"; exit 2' TERM
[ ! -e "$fail.ninja" ] || { echo 'the reason it failed' && exit 1; }
[ -e "$ninja_steps" ] || exit 0
while IFS= read -r step; do
  sleep "$(cat "$ninja_steps.pace")" &
  wait
  printf '%s\n' "$step"
done <"$ninja_steps"
END
stand_in ctest <<'END'
case " $* " in *' -N '*) [ ! -e "$ninja_steps.tests" ] || cat "$ninja_steps.tests" ;; esac
END
echo 'echo 2' | stand_in nproc
# Seconds of a clock on which all tests but the slow ones end after 10 minutes, or 40.
stand_in date <<'END'
if ! grep -q '^ctest' "$calls"; then echo 0; elif [ -e "$fail.late" ]; then echo 2400; else echo 600; fi
END
: | stand_in clang-format
echo 'exit 1' | stand_in npm # no network
stand_in python3 <<'END'
[ ! -e "$fail.python3" ] || { echo 'a circle' && exit 1; }
END
stand_in clang-tidy <<'END'
for word; do :; done
[ ! -e "$fail.clang-tidy" ] || [ "$word" != part/two.cpp ] || { echo 'two.cpp:1: error' && exit 1; }
END
stand_in run-clang-tidy <<'END'
[ ! -e "$fail.clang-tidy" ] || { printf 'clang-tidy -p . two.cpp\n3 warnings generated.\ntwo.cpp:1: error\n' && exit 1; }
END
# The program itself appears where the build would leave it.
program() {
  mkdir -p "$tree/build/release/harness"
  # shellcheck disable=SC2016
  printf '#!/bin/sh\nline=$(printf signorini; printf " <%%s>" "$@")\nprintf "%%s\\n" "$line" >>"$calls"\n' >"$tree/build/release/harness/signorini"
  chmod +x "$tree/build/release/harness/signorini"
}
touch "$tree/part/one.cpp" "$tree/part/two.cpp"

fresh() { # UID [PACKAGE...]: an unbuilt tree on a machine with these packages
  rm -rf "$tree/build" "$packages".* "$fail".* "$ninja_steps" "$ninja_steps".*
  echo "$1" >"$packages.id"
  shift
  printf '%s\n' "$@" >"$packages"
  : >"$calls"
}

bench() { # runs ./bench from elsewhere; its code is in $code, its output in $work/out and $work/err
  code=0
  (cd / && CI='' PATH="$tools:/usr/bin:/bin" "$tree/bench" "$@" >"$work/out" 2>"$work/err") || code=$?
}

report() {
  failures=$((failures + 1))
  printf 'FAILED: %s\n' "$*"
  sed 's/^/  stderr: /' "$work/err"
  sed 's/^/  call: /' "$calls"
}
expect_code() { [ "$code" -eq "$1" ] || report "$2: exit code $code instead of $1"; }
expect_lines() { [ "$(wc -l <"$work/err")" -eq "$1" ] || report "$2: $(wc -l <"$work/err") lines instead of $1"; }
expect_call() { grep -qxF -- "$1" "$calls" || report "$2: no call '$1'"; }
expect_line() { grep -qxF -- "bench: $1" "$work/err" || report "no line '$1'"; }
expect_calls() { # PATTERN COUNT WHAT
  count=$(grep -c -- "$1" "$calls") || true
  [ "$count" -eq "$2" ] || report "$3: $count calls of '$1' instead of $2"
}

fresh 1000 all
bench mistake
expect_code 2 'unknown command'
expect_lines 1 'unknown command'
bench
expect_code 2 'no command'
expect_lines 1 'no command'
bench help
expect_code 0 'help'

fresh 1000 g++ cmake
bench run
expect_code 2 'missing packages without rights'
expect_lines 1 'missing packages without rights'
grep -q 'sudo apt-get .*install .* ninja-build .*libsundials-dev' "$work/err" || report 'the line to type'
! grep -q 'g++\|cmake' "$work/err" || report 'the line to type names what is there'
expect_calls '^apt-get' 0 'without rights'
expect_calls '^cmake' 0 'without packages'

fresh 0 g++
bench run --dry-run
expect_calls '^apt-get .*<install>' 2 'install, update, install'
expect_calls '^apt-get .*<update>' 1 'install, update, install'
expect_calls '^apt-get .*<install>.* <cmake>.*<libeigen3-dev>' 2 'what is missing'
expect_calls '^apt-get .*<g++>' 0 'what is there'
expect_calls '^sudo' 0 'root'

fresh 1000 g++
touch "$packages.sudo" "$packages.updated"
bench test
expect_code 0 'sudo without password'
expect_calls '^sudo <-n> <env> <DEBIAN_FRONTEND=noninteractive> <apt-get>.*<install>' 1 'sudo without password'

fresh 0 g++
touch "$fail.apt-get"
bench run
expect_code 2 'installation fails'
grep -q 'type: sudo apt-get' "$work/err" || report 'installation fails: the line to type'

fresh 1000 all
program
bench run
expect_code 0 'run'
expect_call 'signorini <run> <quick>' 'run'
bench run --scenes 'sdof* chain*' --jobs 2
expect_call 'signorini <run> <quick> <--scenes> <sdof* chain*> <--jobs> <2>' 'run with options'
bench run full --resume
expect_call 'signorini <run> <full> <--resume>' 'run with a suite'
expect_calls '^cmake <-S>' 1 'three runs configure once'
expect_calls '^ninja <-C> <[^>]*> <-j> <2> <signorini>$' 3 'three runs build thrice'
expect_lines 0 'a later run says nothing of its own'

# What it says of a build. Two steps took 100 and 50 s before, the third never ran: it takes what a source did.
fresh 1000 all
program
mkdir -p "$tree/problems"
touch "$tree/problems/a.cpp" "$tree/problems/b.cpp"
bench run
rm -r "$tree/problems"
expect_line 'the first build of signorini: configuring, then 2 sources, about 2 s on 2 cores'
# shellcheck disable=SC2016  # ninja expands it
printf '%s\n' 'build CMakeFiles/facts: phony' \
  'build facts.cpp ${cmake_ninja_workdir}facts.cpp: CUSTOM_COMMAND a || b' '  COMMAND = write facts.cpp' \
  'build CMakeFiles/edit_cache.util: CUSTOM_COMMAND' 'build pages.txt: CUSTOM_COMMAND harness/signorini' |
  cmp -s - "$tree/build/release/bench.ninja" || report 'what runs at every build is counted'
printf '%s\n' '[1/3] Building CXX object x/Unity/unity_0_cxx.cxx.o' '[2/3] Building CXX object x/b.cpp.o' \
  '[3/3] Linking CXX static library x/libx.a' >"$ninja_steps"
echo 1.2 >"$ninja_steps.pace"
mkdir -p "$tree/build/release/x/Unity"
seq 40 | sed 's/.*/#include "\/tree\/&.cpp"/' >"$tree/build/release/x/Unity/unity_0_cxx.cxx"
printf '# ninja log v5\n0\t200\t1\tx/Unity/unity_0_cxx.cxx.o\taa\n0\t100000\t1\tx/Unity/unity_0_cxx.cxx.o\taa\n100\t1100\t1\tx/libx.a\taa\n' \
  >"$tree/build/release/.ninja_log"
bench run
expect_code 0 'run with steps'
expect_line 'building signorini: 3 steps, about 2 min on 2 cores (2 min of the processor)'
sed -n 1p "$work/err" | grep -q building || report 'the estimate is not the first line'
grep -q '^bench: \[[12]/3\] about [0-9]* s left$' "$work/err" || report 'no progress'
[ "$(grep -c '/3\]' "$work/err")" -le 4 ] || report 'a flood of lines'
tail -n 1 "$work/err" | grep -q 'bench: built in ' || report 'the build has no end'
grep -q 'Linking' "$tree/build/build.log" || report 'the whole output is not kept'
sed -i 's/100000/500/' "$tree/build/release/.ninja_log"
bench run
expect_line 'building signorini: 3 steps, about 1 s on 2 cores (2 s of the processor)'
(cd / && PATH="$tools:/usr/bin:/bin" script -qec "'$tree/bench' run" /dev/null </dev/null >"$work/err") || report 'run on a terminal'
tr '\r' '\n' <"$work/err" | grep -q '^.\[Kbench: \[[12]/3\] about [0-9]* s left Building CXX object x/' || report 'no status line on a terminal'
[ "$(wc -l <"$work/err")" -le 2 ] || report 'the status line is not overwritten'

echo 30 >"$ninja_steps.pace"
for signal in TERM:143 INT:130; do
  rm -f "$ninja_steps.ended"
  (cd / && exec env --default-signal=INT PATH="$tools:/usr/bin:/bin" "$tree/bench" run >"$work/out" 2>"$work/err") &
  pid=$!
  waited=0
  until grep -q building "$work/err" 2>/dev/null && tail -n 1 "$calls" | grep -q '<-j>' || [ "$waited" -ge 100 ]; do
    sleep 0.1
    waited=$((waited + 1))
  done
  kill -"${signal%:*}" "$pid"
  code=0
  wait "$pid" || code=$?
  expect_code "${signal#*:}" "interrupted by ${signal%:*}"
  expect_line interrupted
  [ -e "$ninja_steps.ended" ] || report "ninja goes on after ${signal%:*}"
  : >"$calls"
done

fresh 1000 all
bench test
expect_call "ctest <--test-dir> <$tree/build/release> <--output-on-failure> <--parallel> <2> <--no-tests=error> <-LE> <^(slow|long)\$>" 'test'
expect_calls '^npm' 0 'test'
bench test -R 'A b'
expect_calls '<--output-on-failure> .*<-LE> <^(slow|long)\$> <-R> <A b>' 1 'test with options'
expect_calls '<-N> .*<-LE> <^(slow|long)\$> <-R> <A b>' 1 'tests are counted with the same options'
printf '  Test  #1: Lcp.Solves\n  Test #12: Lcp.Ends\n\nTotal Tests: 2\n' >"$ninja_steps.tests"
bench test
expect_line 'running 2 tests, two at a time; how long they take is known after the first time'
mkdir -p "$tree/build/release/Testing/Temporary"
printf 'Lcp.Solves 3 100.5\nLcp.Ends 1 139.7\nLcp.Gone 1 4000\n---\nLcp.Ends\n' >"$tree/build/release/Testing/Temporary/CTestCostData.txt"
bench test
expect_line 'running 2 tests, two at a time: about 2 min'
: >"$calls"
bench test --all -V
expect_calls '^ctest .*<--output-on-failure> .*<-V>' 1 'all tests'
expect_calls '<-LE>' 0 'all tests'
expect_calls '^npm <pack>' 1 'all tests'
: >"$calls"
(cd / && CI=true PATH="$tools:/usr/bin:/bin" "$tree/bench" test >/dev/null)
expect_calls '^ctest .*<--output-on-failure>' 2 'CI=true'
expect_calls '<--output-on-failure> .*<-LE> <^(slow|long)\$>' 1 'CI=true'
expect_calls '<--output-on-failure> .*<-L> <^slow\$> <-LE> <^long\$>' 1 'CI=true'
: >"$calls"
touch "$fail.late"
(cd / && CI=true PATH="$tools:/usr/bin:/bin" "$tree/bench" test >/dev/null 2>"$work/err")
expect_calls '^ctest .*<--output-on-failure>' 1 'CI=true, late'
grep -q 'slow are left out: 40 minutes' "$work/err" || report 'CI=true, late: not said'
: >"$calls"
(cd / && CI=true PATH="$tools:/usr/bin:/bin" "$tree/bench" test -R slow >/dev/null)
expect_calls '^ctest .*<--output-on-failure> .*<-LE> <^long\$> <-R> <slow>' 1 'CI=true with options'

fresh 1000 all
touch "$fail.ninja"
bench test
expect_code 1 'build fails'
grep -q 'the reason it failed' "$work/err" || report 'build fails: no reason shown'
expect_calls '^ctest' 0 'build fails'

fresh 1000 all
bench lint
expect_code 0 'lint'
expect_calls '^run-clang-tidy <-quiet> <-j> <[0-9]*> <-p> <[^>]*/build/lint>$' 1 'lint checks all'
expect_calls '^clang-format <--dry-run> <-Werror> <./part/' 1 'lint checks format'
expect_calls '<-i>' 0 'lint changes nothing'
seq 84 | sed 's/.*/  "file": "&.cpp"/' >"$tree/build/lint/compile_commands.json"
touch "$fail.clang-tidy"
bench lint
expect_line 'clang-tidy: 84 units, about 14 min on 2 cores'
expect_code 1 'lint finds something'
grep -q '^two.cpp:1: error' "$work/err" || report 'lint finds something: not shown'
! grep -q 'generated\|^clang-tidy -p' "$work/err" || report 'lint finds something: noise shown'
: >"$calls"
(cd "$tree" && PATH="$tools:/usr/bin:/bin" "$tree/bench" lint part/one.cpp part/two.cpp >/dev/null 2>"$work/err") && report 'lint of two files: finds nothing'
expect_calls '^run-clang-tidy' 0 'lint of two files'
expect_calls '^clang-tidy <--quiet> <-p> <[^>]*/build/lint> <part/one.cpp>$' 1 'lint of two files'
grep -q '^two.cpp:1: error' "$work/err" || report 'lint of two files: not shown'
bench lint part/none.cpp
expect_code 2 'lint of a file that is not there'
rm "$fail.clang-tidy"
bench lint --fix
expect_code 0 'lint --fix'
expect_calls '^clang-format <-i> <./part/' 1 'lint --fix formats'
expect_call "python3 <-B> <$tree/tests/architecture/rooms.py> <$tree>" 'lint checks the tree'
expect_call "python3 <-B> <$tree/tests/architecture/dear.py> <$tree>" 'lint checks dear headers'
touch "$fail.python3"
bench lint
expect_code 1 'lint finds a circle'
grep -q 'a circle' "$work/err" || report 'lint finds a circle: not shown'
rm "$fail.python3"
bench lint --mistake
expect_code 2 'unknown option of lint'
expect_lines 1 'unknown option of lint'

[ "$failures" -eq 0 ] || exit 1
echo 'all of ./bench as it should be'
