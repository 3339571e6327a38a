#!/usr/bin/env python3
"""A method that is a command and misbehaves as the option deed of the request on stdin says."""

import json
import os
import resource
import signal
import sys
import time


def motion(problem, count=64, value=0.0, contacts=None):
    period = problem["period"]
    rows = [[value] * count for _ in range(len(problem["contacts"]) if contacts is None else contacts)]
    return {"t": [i * period / count for i in range(count)], "x": rows, "velocity": rows, "force": rows}


def say(answer):
    print(json.dumps(answer))


def stand_still(problem, **more):
    say({"verdict": "converged", "trajectory": motion(problem), **more})


def raise_signal(which):
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    signal.signal(which, signal.SIG_DFL) if which not in (signal.SIGKILL, signal.SIGSTOP) else None
    os.kill(os.getpid(), which)
    time.sleep(60)


def stay(ignoring=(), closing=()):
    for which in ignoring:
        signal.signal(which, signal.SIG_IGN)
    for descriptor in closing:
        os.close(descriptor)
    time.sleep(3600)


def leave_children(count, detached):
    """Children that outlive it, if they can."""
    for _ in range(count):
        if os.fork() == 0:
            if detached:
                os.setsid()
                if os.fork():
                    os._exit(0)
            for which in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
                signal.signal(which, signal.SIG_IGN)
            time.sleep(3600)
            os._exit(0)


def with_children(problem, count, detached):
    leave_children(count, detached)
    stand_still(problem)


def flood(stream, text, megabytes):
    for _ in range(megabytes * (1 << 20) // len(text)):
        stream.write(text)
    stream.flush()


def spoilt(problem, **changes):
    answer = motion(problem)
    answer.update(changes)
    say({"verdict": "converged", "trajectory": answer})


def events(problem, *listed):
    stand_still(problem, events=list(listed))


def hog():
    kept = []
    while True:
        kept.append(bytearray(1 << 26))


IMPACT = {"kind": "impact", "contact": 0, "time": 0.1, "impulse": -1.0}
DEEDS = {
    "silent": lambda p: None,
    "exit-3": lambda p: sys.exit(3),
    "abort": lambda p: raise_signal(signal.SIGABRT),
    "segv": lambda p: raise_signal(signal.SIGSEGV),
    "kill-itself": lambda p: raise_signal(signal.SIGKILL),
    "stop-itself": lambda p: raise_signal(signal.SIGSTOP),
    "kill-parent": lambda p: os.kill(os.getppid(), signal.SIGKILL),
    "stop-parent": lambda p: (os.kill(os.getppid(), signal.SIGSTOP), stand_still(p)),
    "kill-group": lambda p: os.killpg(0, signal.SIGKILL),
    "sleep": lambda p: stay(),
    "sleep-ignoring": lambda p: stay(ignoring=(signal.SIGTERM, signal.SIGINT)),
    "sleep-closed": lambda p: stay(closing=(0, 1, 2)),
    "children": lambda p: with_children(p, 20, False),
    "orphans": lambda p: with_children(p, 5, True),
    "orphans-and-sleep": lambda p: (leave_children(3, True), stay()),
    "spin": lambda p: [None for _ in iter(int, 1)],
    "hog": lambda p: hog(),
    "flood-out": lambda p: flood(sys.stdout, "a" * 65536, 64),
    "flood-lines": lambda p: flood(sys.stdout, "{}\n" * 10000, 32),
    "flood-err": lambda p: (flood(sys.stderr, "a" * 65536, 64), stand_still(p)),
    "flood-for-ever": lambda p: [flood(sys.stderr, "b" * 65536, 1) for _ in iter(int, 1)],
    "rubbish": lambda p: sys.stdout.buffer.write(bytes(range(256)) * 100),
    "half": lambda p: print('{"verdict": "converged", "trajectory": {"t": [0'),
    "trailing": lambda p: (stand_still(p), print("more")),
    "twice": lambda p: (stand_still(p), stand_still(p)),
    "utf-16": lambda p: sys.stdout.buffer.write('{"verdict": "not-converged"}'.encode("utf-16")),
    "deep-list": lambda p: print('{"verdict": "converged", "trajectory": ' + "[" * 1000000),
    "deep-object": lambda p: print('{"a":' * 200000 + "1" + "}" * 200000),
    "huge-number": lambda p: print('{"verdict": "converged", "residual": 1e999}'),
    "no-number": lambda p: print('{"verdict": "converged", "residual": NaN}'),
    "exit-after-answer": lambda p: (stand_still(p), sys.stdout.flush(), os._exit(1)),
    "abort-after-answer": lambda p: (stand_still(p), sys.stdout.flush(), raise_signal(signal.SIGABRT)),
    "sleep-after-answer": lambda p: (stand_still(p), sys.stdout.flush(), stay()),
    "stand-still": stand_still,
    "gave-up": lambda p: say({"verdict": "not-converged", "message": "it is hard"}),
    "no-motion": lambda p: say({"verdict": "converged"}),
    "strange-verdict": lambda p: say({"verdict": "yes"}),
    "list-verdict": lambda p: say({"verdict": ["converged"]}),
    "strange-key": lambda p: stand_still(p, colour="red"),
    "message-5-mb": lambda p: stand_still(p, message="a" * 5000000),
    "message-escapes": lambda p: stand_still(p, message="\x1b[2J\r\n\x00\u009b</script>'`$(touch PWN)"),
    "message-number": lambda p: stand_still(p, message=7),
    "period-0": lambda p: stand_still(p, period=0),
    "period-negative": lambda p: stand_still(p, period=-1.0),
    "period-1e9": lambda p: say({"verdict": "converged", "period": 1e9 * p["period"],
                                 "trajectory": {"t": [0], "x": [[0]], "velocity": [[0]], "force": [[0]]}}),
    "period-1e300": lambda p: stand_still(p, period=1e300),
    "period-tiny": lambda p: stand_still(p, period=1e-300),
    "one-instant": lambda p: say({"verdict": "converged", "trajectory": motion(p, 1)}),
    "million-instants": lambda p: say({"verdict": "converged", "trajectory": motion(p, 1000000)}),
    "no-contacts": lambda p: say({"verdict": "converged", "trajectory": motion(p, 64, 0.0, 0)}),
    "many-contacts": lambda p: say({"verdict": "converged", "trajectory": motion(p, 64, 0.0, 500)}),
    "uneven": lambda p: spoilt(p, x=[[0.0] * 63]),
    "empty-lists": lambda p: spoilt(p, t=[], x=[[]], velocity=[[]], force=[[]]),
    "no-lists": lambda p: spoilt(p, t=0, x=0),
    "texts": lambda p: spoilt(p, x=[["a"] * 64]),
    "nulls": lambda p: spoilt(p, x=[[None] * 64]),
    "huge-motion": lambda p: say({"verdict": "converged", "trajectory": motion(p, 64, 1e308)}),
    "tiny-motion": lambda p: say({"verdict": "converged", "trajectory": motion(p, 64, 1e-320)}),
    "far-motion": lambda p: say({"verdict": "converged", "trajectory": motion(p, 64, -1e6)}),
    "stand-before-the-stop": lambda p: say({"verdict": "converged", "trajectory": motion(p, 64, p["contacts"][0]["gap"] - 0.1)}),
    "times-else": lambda p: spoilt(p, t=[0.0] * 64),
    "impulse-elsewhere": lambda p: spoilt(p, impulses=[{"contact": 7, "time": 0.1, "value": -1.0}]),
    "impulse-late": lambda p: spoilt(p, impulses=[{"contact": 0, "time": 1e9, "value": -1.0}]),
    "impulse-index": lambda p: spoilt(p, impulses=[{"contact": 1e300, "time": 0.1, "value": -1.0}]),
    "many-impulses": lambda p: spoilt(p, impulses=[{"contact": 0, "time": 0.1, "value": -1e-9}] * 100000),
    "bandwidth-negative": lambda p: spoilt(p, bandwidth=-5),
    "bandwidth-huge": lambda p: spoilt(p, bandwidth=2000000000),
    "bandwidth-half": lambda p: spoilt(p, bandwidth=0.5),
    "work-unknown": lambda p: stand_still(p, work={"gold": 1}),
    "work-negative": lambda p: stand_still(p, work={"iterations": -1}),
    "work-huge": lambda p: stand_still(p, work={"iterations": 1e300}),
    "events-elsewhere": lambda p: events(p, dict(IMPACT, contact=9)),
    "events-late": lambda p: events(p, dict(IMPACT, time=1e9)),
    "events-backwards": lambda p: events(p, IMPACT, dict(IMPACT, time=0.05)),
    "events-unknown": lambda p: events(p, dict(IMPACT, kind="miracle")),
    "events-many": lambda p: events(p, *[dict(IMPACT, time=i * 1e-6) for i in range(50000)]),
    "events-pull": lambda p: events(p, dict(IMPACT, impulse=1.0)),
}


def main():
    request = json.loads(sys.stdin.buffer.read())
    DEEDS[request["options"]["deed"]](request["problem"])


if __name__ == "__main__":
    main()
