"""What a release ships, made of this build and installed into empty roots of Debian: release_test.py TREE BUILD FOLDER PART.

PART is one of: files (makes them below FOLDER/files and looks into them), deb, container (its last stage, which is the wheel), source
(both stages of the container, from the tarball: it compiles the program).
"""

import configparser
import importlib.util
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import zipfile

import empty_root

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "python"))
import support  # noqa: E402  # the closed form of an oscillator with one impact per period

TREE, BUILD, FOLDER = map(pathlib.Path, sys.argv[1:4])
FILES = FOLDER / "files"
VERSION = re.search(r"^project\(signorini VERSION ([\d.]+)", (TREE / "CMakeLists.txt").read_text(), re.M)[1]


def check(fact, text):
    if not fact:
        raise AssertionError(text)


def output(*words, **options):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False, **options)
    check(done.returncode == 0, f"{words}\n{done.stdout[-3000:]}{done.stderr[-3000:]}")
    return done.stdout


def made(pattern):
    found = list(FILES.glob(pattern))
    check(len(found) == 1, f"{FILES} has {found}: must hold one file {pattern}")
    return found[0]


def in_git():
    return subprocess.run(["git", "-C", str(TREE), "rev-parse", "--verify", "HEAD"], capture_output=True, check=False).returncode == 0


# --- the files ---

def files():
    for command in ("cpack", "dpkg-shlibdeps", "patchelf"):
        if shutil.which(command) is None:
            empty_root.skip(f"{command} is not installed")
    if not all(map(importlib.util.find_spec, ("pip", "setuptools", "wheel"))):
        empty_root.skip("python3-pip, python3-setuptools and python3-wheel are not all installed")
    what = ["tarball", "deb", "wheel"] if in_git() else ["deb", "wheel"]
    shutil.rmtree(FILES, ignore_errors=True)
    output("sh", TREE / "cmake/release/packages.sh", BUILD, FILES, *what, env={"PATH": "/usr/sbin:/usr/bin:/sbin:/bin"})
    sums = dict(reversed(line.split()) for line in (FILES / "SHA256SUMS").read_text().splitlines())
    check(sorted(sums) == sorted(path.name for path in FILES.iterdir() if path.name != "SHA256SUMS"), f"SHA256SUMS names {sorted(sums)}")
    if in_git():
        look_into_tarball()
    look_into_packages()
    look_into_wheel()


def look_into_tarball():
    commit = output("git", "-C", TREE, "rev-parse", "HEAD").strip()
    with tarfile.open(made("*.tar.gz")) as tarball:
        names = {member.name for member in tarball if not member.isdir()}
        expected = {f"signorini-{VERSION}/{name}" for name in output("git", "-C", TREE, "ls-tree", "-r", "--name-only", "HEAD").splitlines()}
        check(names == expected, f"the tarball lacks {sorted(expected - names)[:5]} and has {sorted(names - expected)[:5]} beyond what is committed")
        facts = tarball.extractfile(f"signorini-{VERSION}/cmake/build_info.cmake").read().decode()
    check(f'set(COMMIT "{commit}")' in facts, "the tarball does not tell its commit to the build")


def look_into_packages():
    fields = {}
    for package in FILES.glob("*.deb"):
        control = configparser.RawConfigParser()
        control.read_string("[control]\n" + output("dpkg-deb", "--field", package))
        name, fields[name] = control["control"]["Package"], control["control"]
        check(control["control"]["Version"] == VERSION, f"{package} is version {control['control']['Version']}: must be {VERSION}")
        for file in ("copyright", "changelog.gz"):
            check(f" ./usr/share/doc/{name}/{file}\n" in output("dpkg-deb", "--contents", package), f"{package} has no {file}")
    check({"signorini", "signorini-dev"} <= set(fields), f"the packages are {sorted(fields)}")
    contents = output("dpkg-deb", "--contents", made(f"signorini_{VERSION}_*.deb"))
    for file in ("man/man1/signorini.1.gz", "signorini/SKILL.md", "signorini/problems/catalogue/sdof-stop.toml"):
        check(f" ./usr/share/{file}\n" in contents, f"signorini has no /usr/share/{file}")
    depends = fields["signorini"]["Depends"]
    for library in ("libc6", "libfftw3-double3", "libumfpack5", "liblapack3"):
        check(re.search(rf"\b{library}\b", depends), f"signorini depends on {depends}: {library} is missing")
    check("mpi" not in depends, f"signorini depends on {depends}: MPI is the affair of signorini-mpi")
    check(re.search(rf"\bsignorini \(= {re.escape(VERSION)}\)", fields["signorini-dev"]["Depends"]), "signorini-dev goes with another program")


def look_into_wheel():
    wheel = made("*.whl")
    check(re.fullmatch(rf"signorini-{re.escape(VERSION)}-py3-none-manylinux_2_\d+_\w+\.whl", wheel.name), wheel.name)
    with zipfile.ZipFile(wheel) as archive:
        names = set(archive.namelist())
        licences = f"signorini-{VERSION}.dist-info/licenses"
        packages = re.findall(r"^(\S+) ", archive.read(f"{licences}/libraries.txt").decode(), re.M)[1:]
        for name in ("copyright", *packages):
            check(f"{licences}/{name}" in names, f"the wheel has no licence of {name}")
        check("GPL-3.0-or-later" in archive.read(f"signorini-{VERSION}.dist-info/METADATA").decode(), "the wheel does not say under which licence it is")


# --- the answers ---

def readme():
    """The scene of README.md, and the commands on it that answer in seconds."""
    text = (TREE / "README.md").read_text()
    scene = re.search(r"^```toml\n(.*?)^```$(.*?)^## ", text, re.M | re.S)
    commands = [line.split("#")[0].strip() for line in re.findall(r"^signorini .*", scene[2], re.M)]
    check(len(commands) >= 4, f"README.md has the commands {commands} on its scene")
    return scene[1], [command for command in commands if not command.startswith("signorini run")]


def answer_as_readme(root):
    scene, commands = readme()
    name = re.search(r"\bmy-scene\.toml\b", " ".join(commands))[0]
    work = root.folder / "work"
    work.mkdir()
    (work / name).write_text(scene)
    for command in commands:
        check(root.run(f"cd /work && {command}").strip(), f"{command} says nothing")
        for picture in re.findall(r"--plot (\S+)", command):
            check((work / picture).stat().st_size > 2000, f"{command} draws nothing")
    check_answer(json.loads(root.run(f"cd /work && signorini solve {name} --method exact-orbit --json")))
    check(root.run("signorini --version").startswith(f"signorini {VERSION} "), "the program has another version")
    check("sdof-stop" in root.run("signorini list scenes"), "the program does not find its scenes")


def check_answer(record):
    """The record of the scene of README.md against its closed form."""
    impacts = record["motion"]["impacts"]
    exact = support.Oscillator(frequency=2.2, gap=0.2, restitution=0.8).impacts()
    near = min(abs(impacts[0]["time"] - time) + abs(impacts[0]["speed_before"] - speed) for time, speed in exact)
    check(len(impacts) == 1 and near < 1e-9, f"the impacts are {impacts}, {near} off the closed form")


def deb():
    root = empty_root.EmptyRoot.copy(FOLDER, "deb")
    for package in FILES.glob("*.deb"):
        shutil.copy(package, root.folder / "tmp")
    root.run(f"apt-get install -q -y /tmp/signorini_{VERSION}_*.deb")
    answer_as_readme(root)
    root.run("apt-get install -q --simulate /tmp/signorini-*.deb")
    check("no longer" in root.outcome("apt-get remove -q -y signorini && ! command -v signorini && echo no longer").stdout,
          "the program is still there after its removal")
    root.remove()


# --- the container ---

def stages():
    """The instructions of each stage of the Dockerfile, as pairs of word and argument."""
    text = (TREE / "Dockerfile").read_text()
    lines = re.sub(r"\\\n\s*", " ", re.sub(r"^#.*\n", "", text, flags=re.M)).splitlines()
    instructions = [tuple(line.split(None, 1)) for line in lines if line.strip()]
    starts = [i for i, (word, _) in enumerate(instructions) if word == "FROM"] + [len(instructions)]
    return [instructions[begin:end] for begin, end in zip(starts, starts[1:])]


def build_stage(instructions, root, copies):
    """Does what the instructions say in a root; copies: source of a COPY -> folder or files of this machine."""
    where = "/"
    check(re.match(rf"debian:12-slim\b", instructions[0][1]), f"FROM {instructions[0][1]}: must be debian:12-slim")
    for word, argument in instructions[1:]:
        if word == "WORKDIR":
            where = argument
        elif word == "RUN":
            root.run(f"cd {where} && {argument}")
        elif word == "COPY":
            source, target = argument.split()[-2:]
            shutil.copytree(copies[source], root.folder / target.lstrip("/"), symlinks=True)
        else:
            check(word == "ENTRYPOINT" and json.loads(argument) == ["signorini"], f"{word} {argument}: not known to this test")


def answer_as_python(root):
    code = "import signorini; print(signorini.__version__, signorini.Scene.load('sdof-stop').solve().certified, signorini.find_program())"
    version, certified, program = root.run(f'/opt/signorini-python/bin/python -c "{code}"').split()
    check((version, certified) == (VERSION, "True"), f"from Python: {version}, certified {certified}")
    check(program.startswith("/opt/signorini-python/lib/"), f"Python takes the program {program}: must be that of the wheel")
    loaded = dict(re.findall(r"^\s*(\S+) => (/\S+)", root.run(f"ldd {program}"), re.M))
    check("/prefix/" in loaded["libfftw3.so.3"], f"FFTW is taken from {loaded['libfftw3.so.3']}: must be that of the wheel")


def container():
    root = empty_root.EmptyRoot.copy(FOLDER, "container")
    build_stage(stages()[-1], root, {"/packages": FILES})
    answer_as_readme(root)
    answer_as_python(root)
    root.remove()


def source():
    if not in_git():
        empty_root.skip("this tree is no git repository, of which a tarball could be made")
    root = empty_root.EmptyRoot.copy(FOLDER, "source")
    with tarfile.open(made("*.tar.gz")) as tarball:
        tarball.extractall(FOLDER / "unpacked")
    build_stage(stages()[0], root, {".": FOLDER / "unpacked" / f"signorini-{VERSION}"})
    last = empty_root.EmptyRoot.copy(FOLDER, "container")
    build_stage(stages()[-1], last, {"/packages": root.folder / "packages"})
    answer_as_readme(last)
    answer_as_python(last)
    commit = output("git", "-C", TREE, "rev-parse", "HEAD").strip()
    check(commit[:12] in last.run("signorini --version"), "what was built of the tarball does not tell its commit")
    for folder in (root.folder, last.folder, FOLDER / "unpacked"):
        shutil.rmtree(folder)


if __name__ == "__main__":
    {"files": files, "deb": deb, "container": container, "source": source}[sys.argv[4]]()
