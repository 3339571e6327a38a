#!/bin/sh
# packages.sh BUILD OUT [tarball] [deb] [wheel]: the files of a release, from the tree that holds this script and its build: the tarball of
# what is committed, Debian packages, the Python wheel with the program inside; all three unless named. docs/releasing.md
# says when. Needs git for the first, dpkg-dev and file for the second, and for the third what wheel.py names.
set -eu

tree=$(dirname -- "$(readlink -f -- "$0")")/../..
tree=$(readlink -f -- "$tree")
build=$(readlink -f -- "$1")
mkdir -p "$2"
out=$(readlink -f -- "$2")
shift 2
[ $# -gt 0 ] || set -- tarball deb wheel

die() {
  echo "packages.sh: $*" >&2
  exit 2
}

version=$(sed -n 's/^project(signorini VERSION \([0-9.]*\) .*/\1/p' "$tree/CMakeLists.txt")
told=$("$build/harness/signorini" --version | sed 's/^signorini \([0-9.]*\).*/\1/;q')
[ "$told" = "$version" ] || die "the program of $build is version $told, the tree $version: build it"

for what; do
  case $what in
    tarball)
      git -C "$tree" rev-parse --verify --quiet HEAD >/dev/null || die "$tree: no git repository, of which a tarball could be made"
      [ -z "$(git -C "$tree" status --porcelain)" ] || echo 'packages.sh: what is not committed is not in the tarball' >&2
      git -C "$tree" archive --format=tar --prefix="signorini-$version/" HEAD | gzip -9n >"$out/signorini-$version.tar.gz"
      ;;
    deb)
      rm -f "$out"/signorini*_"$version"_*.deb
      (cd "$out" && cpack -G DEB --config "$build/CPackConfig.cmake" -B "$out" >"$out/cpack.log" 2>&1) || { cat "$out/cpack.log" >&2 && exit 1; }
      rm -rf "$out/_CPack_Packages" "$out/cpack.log"
      ;;
    wheel)
      rm -f "$out/signorini-$version"-*.whl
      /usr/bin/env python3 -B "$tree/cmake/release/wheel.py" "$tree" "$build" "$out" >&2
      ;;
    *) die "$what (known: tarball, deb, wheel)" ;;
  esac
done
(cd "$out" && sha256sum -- signorini*"$version"*.* >SHA256SUMS && cat SHA256SUMS)
