"""A Debian with nothing but what debootstrap gives (variant minbase), in a folder, and commands in it. Needs root and a Debian mirror."""

import os
import pathlib
import shutil
import subprocess
import sys

ENTER = """mount -t proc proc "$1/proc" && mount --bind /dev "$1/dev" && exec chroot "$1" env -i HOME=/root LC_ALL=C.UTF-8 \
PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive sh -euc "$2" """


def skip(reason):
    """Ends the test as ctest's SKIP_RETURN_CODE has it."""
    print(f"skipped: {reason}")
    sys.exit(77)


def codename():
    """The release of Debian that this machine runs."""
    facts = dict(line.rstrip().split("=", 1) for line in open("/etc/os-release", encoding="utf-8") if "=" in line)
    if facts.get("ID") != "debian":
        skip("this machine does not run Debian")
    return facts["VERSION_CODENAME"].strip('"')


def mirror(name):
    """The mirror from which this machine has that release."""
    lines = subprocess.run(["apt-get", "indextargets", "--format", "$(ORIGIN) $(CODENAME) $(REPO_URI)"], capture_output=True, text=True, check=False)
    for line in lines.stdout.splitlines():
        if line.startswith(f"Debian {name} "):
            return line.split()[2]
    skip(f"this machine has no list of packages of Debian {name} (apt-get update)")


def base(folder):
    """The folder of a root as debootstrap leaves it, with lists of packages; made once, then kept."""
    root, made = folder / "base", folder / "base.made"
    if made.exists():
        return root
    if os.geteuid() != 0 or subprocess.run(["unshare", "--mount", "--pid", "--fork", "true"], check=False).returncode != 0:
        skip("no right to enter a root of its own")
    if shutil.which("debootstrap") is None:
        skip("debootstrap is not installed")
    shutil.rmtree(root, ignore_errors=True)
    folder.mkdir(parents=True, exist_ok=True)
    name = codename()
    done = subprocess.run(["debootstrap", "--variant=minbase", name, str(root), mirror(name)], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        skip(f"debootstrap: {(done.stdout + done.stderr).strip().splitlines()[-1]}")
    (root / "etc/dpkg/dpkg.cfg.d/unsafe-io").write_text("force-unsafe-io\n")  # a root that is thrown away need not reach the disk
    for file in ("/etc/resolv.conf", "/etc/hosts"):
        if os.path.exists(file):
            shutil.copy(file, root / "etc")
    if EmptyRoot(root).outcome("apt-get -q -o APT::Update::Error-Mode=any update").returncode != 0:
        skip("the mirror of Debian cannot be reached from an empty root")
    made.touch()
    return root


class EmptyRoot:
    """A root in a folder."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)

    @classmethod
    def copy(cls, folder, name):
        """A fresh copy of the base, in place of an earlier one of that name."""
        target = folder / name
        source = base(folder)
        shutil.rmtree(target, ignore_errors=True)
        subprocess.run(["cp", "-a", "--reflink=auto", str(source), str(target)], check=True)
        return cls(target)

    def outcome(self, command):
        return subprocess.run(["unshare", "--mount", "--pid", "--fork", "--kill-child", "sh", "-euc", ENTER, "sh", str(self.folder), command],
                              stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)

    def run(self, command):
        """Standard output of a line of sh in the root, which must succeed."""
        done = self.outcome(command)
        if done.returncode != 0:
            raise AssertionError(f"{command}\nended with {done.returncode}:\n{done.stdout[-3000:]}{done.stderr[-3000:]}")
        return done.stdout

    def remove(self):
        shutil.rmtree(self.folder)
