"""The program: how it is found, how it may end, and what becomes of an interrupted one. It is played by scripts."""

import os
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path
from unittest import mock

import support

from signorini import BadInput, Interrupted, ProgramNotFound, Scene, SignoriniError, find_program, program


class Finding(support.TemporaryFolder):
    def test_goes_by_the_variable_then_the_wheel_then_the_path_then_the_tree(self):
        named = self.write("mine", "#!/bin/sh\n", executable=True)
        (self.folder / "bin").mkdir()
        on_path = self.write("bin/signorini", "#!/bin/sh\n", executable=True)
        package = self.folder / "tree" / "python"
        built = self.folder / "tree/build/release/harness/signorini"
        built.parent.mkdir(parents=True)
        inside = package / program.INSIDE
        inside.parent.mkdir(parents=True)
        self.write(inside, "#!/bin/sh\n", executable=True)
        with mock.patch.object(program, "PACKAGE_PARENT", package):
            with mock.patch.dict(os.environ, {"SIGNORINI_PROGRAM": str(named), "PATH": str(on_path.parent)}):
                self.assertEqual(find_program(), named)
                del os.environ["SIGNORINI_PROGRAM"]
                self.assertEqual(find_program(), inside)
                inside.unlink()
                self.assertEqual(find_program(), on_path)
                on_path.unlink()
                with self.assertRaisesRegex(ProgramNotFound, "not on the PATH: build it"):
                    find_program()
                self.write("tree/build/release/harness/signorini", "#!/bin/sh\n", executable=True)
                self.assertEqual(find_program(), built)

    def test_refuses_a_variable_that_names_no_program(self):
        plain = self.write("plain", "no program\n")
        for path in (plain, self.folder, self.folder / "none"):
            with mock.patch.dict(os.environ, {"SIGNORINI_PROGRAM": str(path)}):
                with self.assertRaisesRegex(ProgramNotFound, f"SIGNORINI_PROGRAM = {path}"):
                    Scene.load("sdof-stop")

    def test_tells_of_a_program_that_cannot_be_executed(self):
        broken = self.write("broken", "#!/no/such/interpreter\n", executable=True)
        with mock.patch.dict(os.environ, {"SIGNORINI_PROGRAM": str(broken)}):
            with self.assertRaisesRegex(ProgramNotFound, "broken cannot be run"):
                Scene.load("sdof-stop")


class Ends(support.TemporaryFolder):
    def outcome(self, script):
        path = self.write("signorini", "#!/bin/sh\n" + script, executable=True)
        with mock.patch.dict(os.environ, {"SIGNORINI_PROGRAM": str(path)}):
            with self.assertRaises(SignoriniError) as caught:
                program.run(["show", "sdof-stop"])
        return type(caught.exception), caught.exception.code, str(caught.exception)

    def test_are_exceptions_with_the_one_line_of_the_program(self):
        line = "echo 'a warning before' >&2; echo 'field = value (what is required)' >&2; exit "
        for code, kind in ((1, SignoriniError), (2, BadInput), (3, BadInput), (5, SignoriniError)):
            self.assertEqual(self.outcome(line + str(code)), (kind, code, "field = value (what is required)"))
        self.assertEqual(self.outcome("exit 4"), (SignoriniError, 4, "signorini ended with exit code 4"))
        self.assertEqual(self.outcome("exit 130"), (Interrupted, 130, "signorini was interrupted"))
        self.assertEqual(self.outcome("kill -KILL $$"), (SignoriniError, -9, "signorini was ended by signal 9 (Killed)"))

    def test_that_are_allowed_give_what_was_printed(self):
        path = self.write("signorini", "#!/bin/sh\necho \"$@\"; exit 1\n", executable=True)
        with mock.patch.dict(os.environ, {"SIGNORINI_PROGRAM": str(path)}):
            self.assertEqual(program.run(["solve", Path("a b.toml")], allowed=(0, 1)), "solve a b.toml\n")


class Interrupts(support.TemporaryFolder):
    def interrupt(self, trap):
        """Interrupts a Python process alone while the program runs in it. Returns the process, and the program's id."""
        started = self.folder / "started"
        fake = self.write("signorini", f"#!/bin/sh\ntrap '{trap}' INT\necho $$ >{started}.tmp; mv {started}.tmp {started}\n"
                          "while :; do sleep 0.05; done\n", executable=True)
        code = ("from signorini import program\nprogram.GRACE = 0.5\n"
                "try:\n  program.run(['show'])\nexcept KeyboardInterrupt:\n  print('interrupted')\n")
        environment = {**os.environ, "SIGNORINI_PROGRAM": str(fake), "PYTHONPATH": str(support.ROOT / "python")}
        # In a session of its own, so that only the signal below arrives.
        process = subprocess.Popen([sys.executable, "-B", "-c", code], stdout=subprocess.PIPE, text=True, env=environment,
                                   start_new_session=True)
        self.addCleanup(process.stdout.close)
        while not started.exists():
            self.assertIsNone(process.poll())
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.communicate(timeout=60)[0], "interrupted\n")
        return int(started.read_text())

    def test_end_the_program_too(self):
        for trap in ("exit 130", ""):  # it ends by itself, or ignores the signal
            with self.assertRaises(ProcessLookupError):
                os.kill(self.interrupt(trap), 0)
            (self.folder / "started").unlink()


if __name__ == "__main__":
    unittest.main()
