#!/bin/sh
# install_tree.sh CMAKE BUILD SOURCE FOLDER [CMAKE OPTION...]: installs the build into FOLDER/prefix, and builds there
# the examples that were installed, a method that the program begins, and the plugins of the tests, as a user would.
set -eu

cmake=$1
build=$2
source=$3
folder=$4
shift 4

rm -rf "$folder"
"$cmake" --install "$build" --prefix "$folder/prefix" >"$folder.log"
build_project() { # SOURCE BUILD [OPTION...]
  from=$1
  to=$2
  shift 2
  "$cmake" -S "$from" -B "$to" -DCMAKE_PREFIX_PATH="$folder/prefix" "$@"
  "$cmake" --build "$to" --parallel 2
}
build_project "$folder/prefix/share/signorini/examples/moreau_jean" "$folder/moreau_jean" "$@"
# Whether Siconos is there, all that the example uses, is its own question.
if build_project "$folder/prefix/share/signorini/examples/rivals/siconos" "$folder/siconos" "$@" >"$folder/siconos.log" 2>&1; then
  cat "$folder/siconos.log"
else
  tr '\n' ' ' <"$folder/siconos.log" | grep -q 'Siconos  *is  *not  *installed  *whole' || { cat "$folder/siconos.log" && exit 1; }
  echo 'without Siconos'
fi
(cd "$folder" && "$folder/prefix/bin/signorini" new method begun-outside --out-of-tree)
build_project "$folder/begun-outside" "$folder/begun" "$@"
build_project "$source/tests/plugin/plugins" "$folder/plugins" "$@"
echo 'this is no shared object' >"$folder/plugins/text.so"
