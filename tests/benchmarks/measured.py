#!/usr/bin/env python3
"""Runs a command, and appends what it took to a file: one JSON object a line, of its processes together.

usage: measured.py FILE COMMAND...

{"command": [...], "processor": user and system seconds, "wall": seconds, "mib": the largest of its processes}. The exit code is
the command's. As CMAKE_CXX_COMPILER_LAUNCHER it measures each unit of a build; it takes 0.02 s itself.
"""

import json
import os
import resource
import subprocess
import sys
import time


def main():
    file, command = sys.argv[1], sys.argv[2:]
    begun = time.perf_counter()
    code = subprocess.call(command)
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    line = json.dumps({"command": command, "processor": used.ru_utime + used.ru_stime, "wall": time.perf_counter() - begun,
                       "mib": used.ru_maxrss / 1024}) + "\n"
    kept = os.open(file, os.O_WRONLY | os.O_APPEND | os.O_CREAT, 0o666)
    os.write(kept, line.encode())  # whole, since compilers run side by side
    os.close(kept)
    sys.exit(code if code >= 0 else 128 - code)


if __name__ == "__main__":
    main()
