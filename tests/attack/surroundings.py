"""Machines that are short of something: the command works, or says in one line what it lacks, and TERM ends it."""

import os
import pathlib
import signal
import subprocess
import time

from attacked_program import Campaign

WHOLE = ["run", "quick", "--scenes", "sdof-stop", "--methods", "hat-lcp[samples=64]", "--repetitions", "1", "--out"]
SOLVE = ["solve", "sdof-stop", "--method", "hat-lcp", "--set", "samples=64"]
CURVE = ["sweep", "sdof-stop", "--methods", "exact-orbit", "--from", "2.2", "--to", "2.25", "--total-time", "5", "--format", "csv"]
COMMANDS = [SOLVE, [*SOLVE, "--plot", "p.svg"], CURVE, [*WHOLE, "run"], ["report", "whole", "--format", "md"], ["show", "sdof-stop"]]

# Every signal that a process may ignore is, and is blocked; then the command.
DEAF = ("python3", "-c", """import os, signal, sys
for number in range(1, 32):
    if number not in (signal.SIGKILL, signal.SIGSTOP):
        signal.signal(number, signal.SIG_IGN)
signal.pthread_sigmask(signal.SIG_BLOCK, range(1, 32))
os.execv(sys.argv[1], sys.argv[1:])
""")
# The command on a terminal of so many columns; what it sends to a terminal alone is left out.
TERMINAL = ("python3", "-c", r"""import fcntl, os, pty, re, struct, sys, termios
child, terminal = pty.fork()
if child == 0:
    fcntl.ioctl(1, termios.TIOCSWINSZ, struct.pack("HHHH", 5, int(sys.argv[1]), 0, 0))
    os.execv(sys.argv[2], sys.argv[2:])
text = b""
try:
    while piece := os.read(terminal, 4096):
        text += piece
except OSError:
    pass
os.write(1, re.sub(rb"\r|\x1b\[[0-9;]*[A-Za-z]", b"", text))
sys.exit(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
""")


def closed(*descriptors):
    return ("sh", "-c", f'exec "$@" {" ".join(descriptors)}', "sh")


def mounted(kind, place):
    """With a file system of that kind in place of another one; none where nothing may be mounted."""
    return ("unshare", "--mount", "sh", "-c", f'mount -t tmpfs -o {kind} none {place} && exec "$@"', "sh")


SURROUNDINGS = {
    "stdin is closed": (closed("<&-"), (0,)),
    "stdout is closed": (closed(">&-"), (0,)),
    "stderr is closed": (closed("2>&-"), (0,)),
    "all three are closed": (closed("<&-", ">&-", "2>&-"), (0,)),
    "every signal is ignored and blocked": (DEAF, (0,)),
    "16 descriptors": (("prlimit", "--nofile=16:16"), (0,)),
    "8 descriptors": (("prlimit", "--nofile=8:8"), (0, 2)),
    "6 descriptors": (("prlimit", "--nofile=6:6"), (0, 2)),
    "4 descriptors": (("prlimit", "--nofile=4:4"), (0, 2)),
    "no HOME": (("env", "-u", "HOME"), (0,)),
    "no environment": (("env", "-i"), (0, 2)),  # without PATH there is no gnuplot
    "a decimal comma": (("env", "LC_ALL=de_DE.UTF-8", "LANG=de_DE.UTF-8"), (0,)),
    "no folder for temporary files": (("env", "TMPDIR=/no/such/folder"), (0, 2)),
    "a file for the folder of temporary files": (("env", "TMPDIR=/dev/null"), (0, 2)),
    "/tmp is full": (mounted("size=4k,nr_inodes=1", "/tmp"), (0, 2)),
    "/tmp may only be read": (mounted("ro", "/tmp"), (0, 2)),
    "no /proc": (mounted("ro", "/proc"), (0,)),
    "a terminal of 20 columns": ((*TERMINAL, "20"), (0,)),
    "a terminal of 0 columns": ((*TERMINAL, "0"), (0,)),
    "a clock that jumps": ((), (0,)),
}
LEAST_MB, MOST_MB = 16, 1500  # limits of address space
# The loader's own complaint, before there is a program.
NOT_LOADED = b"error while loading shared libraries"
LONG = [
    ["orbits", "sdof-stop", "--starts", "100000", "--timeout", "100"],
    ["motion", "chaos@2.97", "--starts", "1000", "--timeout", "100"],
    ["sweep", "sdof-stop", "--methods", "exact-orbit", "--from", "0.1", "--to", "4.6", "--total-time", "100", "--max-order", "64"],
    ["sweep", "sdof-stop", "--methods", "exact-orbit", "--from", "2.2", "--to", "2.6", "--total-time", "100", "--max-points", "100000",
     "--follow", "contact-change", "--second", "contact[0].gap", "--second-from", "0.2", "--second-to", "0.3"],
    ["run", "quick", "--out", "long"],
]
SECONDS_TO_END = 10.0  # of a command that has been asked to


def may(words):
    """Whether this user may: mount, or become somebody else."""
    return subprocess.run(words, capture_output=True).returncode == 0


def surroundings(program, random, count, folder, findings):
    campaign = Campaign("commands on machines that are short of something", findings)
    folder.mkdir(exist_ok=True)
    campaign.count(program.run([*WHOLE, "whole"], folder, seconds=60.0))
    plain = program.run(CURVE, folder).out
    cases = [(name, command) for name in SURROUNDINGS for command in COMMANDS if is_possible(name, program)]
    for name, command in random.sample(cases, min(count, len(cases))):
        before, codes = SURROUNDINGS[name]
        if name == "a clock that jumps":
            before = ("env", f"LD_PRELOAD={jumping_clock(program)}")
        outcome = campaign.count(program.run(command, folder, 60.0, before))
        found = broken(program, outcome, codes, command)
        if name == "a decimal comma" and command == CURVE and outcome.out != plain:
            found.append("other numbers")
        campaign.judge(found, f"{name}: {' '.join(command)}")
    if program.slower == 1.0:  # the address sanitizer takes terabytes
        for _ in range(max(1, count // 3)):
            campaign.judge(*little_memory(program, campaign, random, folder))
    campaign.judge(list(no_processes(program, campaign)), "no further process allowed")
    for command in random.sample(LONG, min(len(LONG), max(1, count // 10))):
        campaign.judge(list(ends_when_asked(program, campaign, command, folder)), f"TERM to a deaf {' '.join(command)}")
    yield campaign


def broken(program, outcome, codes, command):
    """What it did not keep; a run has told what it is about to do before it stops, and then says how it goes on."""
    found = program.violations(outcome, codes)
    if command[0] == "run" and outcome.code == 2:
        found = [text for text in found if "lines of complaint" not in text]
        last = outcome.err.splitlines()[-1] if outcome.err else b""
        if len(outcome.err.splitlines()) > 1 and b"--resume" not in last:
            found.append(f"does not say how it goes on: {last!r}")
    return found


def jumping_clock(program):
    return pathlib.Path(program.path).parents[1] / "tests/attack/jumping_clock.so"


def is_possible(name, program):
    if name == "a clock that jumps" and not jumping_clock(program).exists():
        return False
    if name in ("a clock that jumps", "no /proc") and program.slower != 1.0:  # the sanitizers want to be loaded first, and read it
        return False
    if name.startswith("/tmp") and pathlib.Path(program.path).is_relative_to("/tmp"):  # it would be hidden
        return False
    return "unshare" not in SURROUNDINGS[name][0] or may(["unshare", "--mount", "true"])


def little_memory(program, campaign, random, folder):
    """What a limit of address space brings about, and with what."""
    megabytes, command = random.randint(LEAST_MB, MOST_MB), random.choice(COMMANDS)
    outcome = campaign.count(program.run(command, folder, 60.0, ("prlimit", f"--as={megabytes << 20}")))
    found = []
    if outcome.code != 127 or NOT_LOADED not in outcome.err:
        found = broken(program, outcome, (0, 1, 2), command)
    return found, f"{megabytes} MiB of address space: {' '.join(command)}"


def no_processes(program, campaign):
    """Of somebody without the right to another process; of root, who has no such limit, as somebody else."""
    somebody = ("setpriv", "--reuid=65534", "--regid=65534", "--clear-groups") if os.geteuid() == 0 else ()
    if somebody and not may([*somebody, program.path, "--version"]):
        return
    outcome = campaign.count(program.run(SOLVE, "/", before=(*somebody, "prlimit", "--nproc=1:1")))
    yield from program.violations(outcome, codes=(2,))


def ends_when_asked(program, campaign, command, folder):
    process = program.start(command, folder, DEAF)
    time.sleep(1.0 * program.slower)
    asked = time.monotonic()
    os.kill(process.pid, signal.SIGTERM)
    outcome = campaign.count(program.finish(process, 100.0))
    yield from program.violations(outcome, codes=(0, 1, 6, 130, -signal.SIGTERM))
    if (seconds := time.monotonic() - asked) > SECONDS_TO_END * program.slower:
        yield f"ends {seconds:.0f} s after TERM"
