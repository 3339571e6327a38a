"""The program under attack: run under limits, and held to what it promises whatever it is given."""

import dataclasses
import os
import pathlib
import re
import shutil
import signal
import subprocess
import tempfile
import threading
import time

# Words of the program's own for numbers that are none.
NOT_A_NUMBER = re.compile(rb"(?<![\w.'-])-?(?:nan|inf|infinity)(?![\w.-])", re.I)
CONTROL = re.compile(rb"[\x00-\x09\x0b-\x1f\x7f]")
SANITIZER = re.compile(rb"(ERROR: AddressSanitizer[^\n]*|[^\n]*runtime error:[^\n]*|ERROR: LeakSanitizer[^\n]*)")
BUSY = 6.0  # times as long by the clock a call may take on a machine that others use too
LONGEST_LINE = 2000  # of a complaint [bytes]
SANITIZED_SLOWER, SANITIZED_LARGER = 8.0, 6.0  # than the release build, at most


@dataclasses.dataclass
class Outcome:
    """How one call ended; a negative code is the signal that ended it."""

    code: int
    out: bytes
    err: bytes
    seconds: float
    processor_seconds: float  # of all its processes
    peak_mb: float  # of the largest of its processes
    expired: bool


class Program:
    """The built program. Scratch folders live in memory where the machine has such a place."""

    def __init__(self, path, sanitized=False):
        self.path = str(pathlib.Path(path).resolve())
        self.slower = SANITIZED_SLOWER if sanitized else 1.0
        self.larger = SANITIZED_LARGER if sanitized else 1.0
        self.environment = dict(os.environ, ASAN_OPTIONS="detect_leaks=0:allocator_may_return_null=1:exitcode=99",
                                UBSAN_OPTIONS="exitcode=99:print_stacktrace=1")
        self.environment.pop("SIGNORINI_PLUGIN_PATH", None)

    def start(self, arguments, folder, before=()):
        """The running program, its output in files of its own."""
        out, err = tempfile.TemporaryFile(), tempfile.TemporaryFile()
        process = subprocess.Popen([*before, self.path, *arguments], cwd=folder, stdin=subprocess.DEVNULL, stdout=out,
                                   stderr=err, env=self.environment, start_new_session=True)
        process.files = out, err
        return process

    def finish(self, process, seconds, began=None):
        """Waits for it: so many seconds of the processor, or BUSY times as long by the clock. Then it is killed, with what
        it started."""
        began = began or time.monotonic()
        expired = threading.Event()

        def stop():
            expired.set()
            try:
                os.killpg(process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass

        timer = threading.Timer(BUSY * seconds * self.slower, stop)
        timer.start()
        _, status, usage = os.wait4(process.pid, 0)
        timer.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
        texts = []
        for file in process.files:
            file.seek(0)
            texts.append(file.read())
            file.close()
        used = usage.ru_utime + usage.ru_stime
        return Outcome(process.returncode, *texts, time.monotonic() - began, used, usage.ru_maxrss / 1024.0,
                       expired.is_set() or used > seconds * self.slower)

    def run(self, arguments, folder, seconds=10.0, before=()):
        return self.finish(self.start(arguments, folder, before), seconds)

    def violations(self, outcome, codes=(0, 2), memory_mb=2048.0, given=b""):
        """What the program promises of every call and did not keep. `given` holds what it may repeat."""
        found = []
        if outcome.expired:
            found.append(f"no end within {outcome.seconds:.0f} s, {outcome.processor_seconds:.0f} s of the processor")
        elif outcome.code not in codes:
            found.append(f"exit code {outcome.code}: {outcome.err[-300:]!r}")
        if outcome.peak_mb > memory_mb * self.larger:
            found.append(f"{outcome.peak_mb:.0f} MiB")
        if not NOT_A_NUMBER.search(given):
            match = NOT_A_NUMBER.search(outcome.out + outcome.err)
            found += [f"{match[0].decode()} is printed"] if match else []
        found += [match.decode(errors="replace") for match in SANITIZER.findall(outcome.err)]
        for name, text in (("stdout", outcome.out), ("stderr", outcome.err)):
            if CONTROL.search(text):
                found.append(f"control characters on {name}")
            try:
                text.decode()
            except UnicodeDecodeError:
                found.append(f"{name} is no UTF-8")
        if outcome.code == 2 and not found:
            found += complaint_violations(outcome)
        return found


def complaint_violations(outcome):
    """A refusal is one line on stderr; a warning of a line left out, or of a build not to be timed, may stand before it."""
    lines = outcome.err.splitlines()
    last = lines[-1] if lines else b""
    if not last or any(b"left out" not in line and b"not a Release build" not in line for line in lines[:-1]):
        yield f"{len(lines)} lines of complaint"
    if len(last) > LONGEST_LINE:
        yield f"a line of {len(last)} bytes"


class Campaign:
    """One line of the table: what is attacked, how often, and each violation with what brings it about."""

    def __init__(self, what, findings=None):
        self.what, self.tests, self.violations, self.notes = what, 0, [], []
        self.seconds, self.peak_mb, self.codes = 0.0, 0.0, {}
        self.findings = findings

    def fields(self):
        """All that is known of it, as JSON has it."""
        return {key: value for key, value in vars(self).items() if key != "findings"}

    @classmethod
    def of_fields(cls, fields):
        """The campaign that these are of."""
        campaign = cls(fields["what"])
        vars(campaign).update(fields)
        campaign.codes = {int(code): number for code, number in fields["codes"].items()}
        return campaign

    def judge(self, found, reproduction, files=()):
        """Counts one test; what was found is kept with its files."""
        self.tests += 1
        if not found:
            return
        number = len(self.violations) + 1
        self.violations.append(f"{'; '.join(found)} <- {reproduction}")
        if self.findings is None:
            return
        for file in files:
            name = re.sub(r"\W+", "-", self.what)[:40] + f"-{number}-{pathlib.Path(file).name}"
            self.findings.mkdir(parents=True, exist_ok=True)
            if pathlib.Path(file).is_file():
                shutil.copy(file, self.findings / name)

    def count(self, outcome):
        """Takes a call into the sums."""
        self.seconds = max(self.seconds, outcome.seconds)
        self.peak_mb = max(self.peak_mb, outcome.peak_mb)
        self.codes[outcome.code] = self.codes.get(outcome.code, 0) + 1
        return outcome

    def attack(self, program, arguments, folder, files=(), codes=(0, 2), seconds=10.0, memory_mb=2048.0, given=b""):
        """One call of the program, judged."""
        outcome = self.count(program.run(arguments, folder, seconds))
        given += b"\n" + " ".join(arguments).encode("utf-8", "surrogateescape")
        self.judge(program.violations(outcome, codes, memory_mb, given), " ".join(arguments), files)
        return outcome
