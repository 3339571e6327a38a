#!/usr/bin/env python3
"""A Python wheel with the program inside, from a build on Debian.

usage: wheel.py TREE BUILD OUT

Below signorini/prefix/ it holds what `cmake --install` gives of the component `program`, and in lib/ the shared libraries that the
program is linked with, but for those of the C and C++ run time and zlib, which every Linux has. The program finds them by its run
path. Their licences, and the Debian packages of which they are, lie beside the metadata. Needs patchelf, dpkg, and the
Python packages pip, setuptools and wheel; nothing is fetched.
"""

import pathlib
import platform
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile

ON_EVERY_LINUX = re.compile(r"(ld-linux.*|linux-vdso|libc|libm|libdl|librt|libpthread|libgcc_s|libstdc\+\+|libz)\.so(\.|$)")
LICENCE = "GPL-3.0-or-later as a whole, for the libraries inside (licenses/copyright); the sources of signorini are BSD-3-Clause"
SCRIPT = '''#!python
import importlib.util
import os
import sys

package = importlib.util.find_spec("signorini").submodule_search_locations[0]
program = os.path.join(package, "prefix", "bin", "signorini")
os.execv(program, [program, *sys.argv[1:]])
'''


def run(*words, **options):
    """Standard output of a command, whose failure is ours."""
    return subprocess.run([str(word) for word in words], check=True, stdout=subprocess.PIPE, text=True, **options).stdout


def libraries(program):
    """Name -> file of the shared libraries of a program that not every Linux has."""
    found = dict(re.findall(r"^\s*(\S+) => (/\S+)", run("ldd", program), re.M))
    return {name: pathlib.Path(path) for name, path in found.items() if not ON_EVERY_LINUX.match(name)}


def package_of(library):
    """The Debian package of a library, which may be known by the path before /usr was merged."""
    real = library.resolve()
    for path in (real, pathlib.Path(str(real).removeprefix("/usr"))):
        asked = subprocess.run(["dpkg", "-S", str(path)], capture_output=True, text=True, check=False)
        if asked.returncode == 0:
            return asked.stdout.split(":")[0]
    sys.exit(f"wheel.py: {library} is of no Debian package: its licence is not known")


def put_program_inside(package, build):
    """Installs the program below package/prefix, and its libraries beside it; the names of their packages."""
    prefix = package / "prefix"
    run("cmake", "--install", build, "--prefix", prefix, "--component", "program", "--strip")
    program, folder = prefix / "bin" / "signorini", prefix / "lib"
    folder.mkdir()
    packages = set()
    for name, path in libraries(program).items():
        shutil.copy(path, folder / name)  # under the name by which it is asked for, not through links
        run("patchelf", "--force-rpath", "--set-rpath", "$ORIGIN", folder / name)
        packages.add(package_of(path))
    run("patchelf", "--force-rpath", "--set-rpath", "$ORIGIN/../lib", program)
    return sorted(packages)


def tell_licences(metadata, tree, packages):
    """The licences of what is inside, and the versions of the packages, of which the sources are to be had."""
    licences = metadata / "licenses"
    licences.mkdir()
    shutil.copy(tree / "cmake/release/copyright", licences)
    versions = run("dpkg-query", "-W", "-f=${Package} ${Version} (source: ${source:Package} ${source:Version})\n", *packages)
    (licences / "libraries.txt").write_text("Debian packages of the libraries in signorini/prefix/lib:\n" + versions)
    for package in packages:
        shutil.copy(f"/usr/share/doc/{package}/copyright", licences / package)


def main(tree, build, out):
    with tempfile.TemporaryDirectory(prefix="signorini-wheel-") as scratch:
        scratch = pathlib.Path(scratch)
        shutil.copytree(tree / "python", scratch / "python", ignore=shutil.ignore_patterns("__pycache__", "build", "*.egg-info"))
        run(sys.executable, "-m", "pip", "wheel", "--quiet", "--no-index", "--no-deps", "--no-build-isolation",
            "--disable-pip-version-check", "-w", scratch, scratch / "python", stderr=subprocess.STDOUT)
        run(sys.executable, "-m", "wheel", "unpack", "-d", scratch / "open", next(scratch.glob("*.whl")))
        wheel = next((scratch / "open").iterdir())
        metadata = next(wheel.glob("*.dist-info"))
        tell_licences(metadata, tree, put_program_inside(wheel / "signorini", build))
        scripts = wheel / metadata.name.replace(".dist-info", ".data") / "scripts"
        scripts.mkdir(parents=True)
        (scripts / "signorini").write_text(SCRIPT)
        (scripts / "signorini").chmod(0o755)
        glibc = platform.libc_ver()[1].replace(".", "_")
        machine = sysconfig.get_platform().split("-")[-1]
        for file, change in (("METADATA", (r"^License: .*$", f"License: {LICENCE}")),
                             ("WHEEL", (r"^Root-Is-Purelib: true$", "Root-Is-Purelib: false")),
                             ("WHEEL", (r"^Tag: .*$", f"Tag: py3-none-manylinux_{glibc}_{machine}"))):
            text, count = re.subn(*change, (metadata / file).read_text(), flags=re.M)
            if count != 1:
                sys.exit(f"wheel.py: {file} of the wheel has {count} lines {change[0]}: must be 1")
            (metadata / file).write_text(text)
        print(run(sys.executable, "-m", "wheel", "pack", "-d", out, wheel).strip())


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*(pathlib.Path(word).resolve() for word in sys.argv[1:]))
