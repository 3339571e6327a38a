#!/usr/bin/env python3
"""Scenes that people brought to other programs, tests/data/outside, and what an independent flow, a closed form or a publication
says of them (cases.json): outside_cases_test.py PROGRAM [--all].

The first method of `solve` is certified and gives that motion, but for what is slow. With --all the others are, too, those of `also` are certified or
say why not, and `orbits` lists all motions that are named. Numbers agree to 5e-4 of the amplitude, or of themselves: extremes of the sources are
those of samples."""

import argparse
import json
import math
import pathlib
import subprocess
import sys

DATA = pathlib.Path(__file__).resolve().parent.parent / "data" / "outside"
NEAR = 5e-4


def run(program, *words):
    """Its answer; exit codes other than done and not converged are offences."""
    end = subprocess.run([program, *map(str, words)], capture_output=True, text=True, check=False)
    if end.returncode not in (0, 1) or "NaN" in end.stdout:
        raise AssertionError(f"exit code {end.returncode}: {end.stderr.strip() or 'not a number'}")
    return json.loads(end.stdout)


def apart(told, wanted, scale):
    return not abs(told - wanted) <= NEAR * scale


def differences(record, wanted):
    """What a record of `solve` does not have as it is wanted."""
    motion, certificate = record["motion"], record["certificate"]
    if certificate["status"] != "certified":
        yield f"certificate {certificate['status']}: {certificate.get('reason')}"
    for key in ("x", "u"):
        for told, (least, most) in zip(motion.get(key, []), wanted.get(key, [])):
            size = max(most - least, 1e-5 * abs(least), 1e-9)
            if apart(told["min"], least, size) or apart(told["max"], most, size):
                yield f"{key} {told['min']} .. {told['max']}, not {least} .. {most}"
    for key in ("x", "u"):
        amplitude = wanted.get(f"amplitude_of_{key}0")
        if amplitude is not None and apart(motion[key][0]["amplitude"], amplitude, amplitude):
            yield f"amplitude of {key}[0] {motion[key][0]['amplitude']}, not {amplitude}"
    impulses = [impact["impulse"] for impact in motion["impacts"]]
    known = wanted.get("impulses", wanted.get("first_impulses"))
    if known is not None:
        if "impulses" in wanted and len(impulses) != len(known):
            yield f"{len(impulses)} impacts, not {len(known)}"
        if any(apart(one, other, abs(other)) for one, other in zip(impulses, known)):
            yield f"impulses {impulses}, not {known}"
    if "impacts" in wanted and len(impulses) != wanted["impacts"]:
        yield f"{len(impulses)} impacts, not {wanted['impacts']}"
    if "contact_impulse" in wanted:
        pushed = sum(phase["impulse"] for phase in motion["contact_phases"])
        if apart(pushed, wanted["contact_impulse"], abs(wanted["contact_impulse"])):
            yield f"contact presses {pushed} N s, not {wanted['contact_impulse']}"
    if "contact_ratio" in wanted and apart(record["physics"]["contact_ratio"], wanted["contact_ratio"], 1.0):
        yield f"closed for {record['physics']['contact_ratio']} of the period"
    yield from differences_of_stability(certificate, wanted)


def differences_of_stability(certificate, wanted):
    if "stable" in wanted and certificate.get("stable") != wanted["stable"]:
        yield f"stable {certificate.get('stable')}, not {wanted['stable']}"
    if "largest_multiplier" in wanted:
        largest = max((math.hypot(*one) for one in certificate.get("floquet", [])), default=math.inf)
        if apart(largest, wanted["largest_multiplier"], wanted["largest_multiplier"]):
            yield f"largest multiplier {largest}, not {wanted['largest_multiplier']}"


def is_orbit(told, wanted):
    impulses = sorted(event["value"] for event in told["events"] if event["kind"] == "impact")
    known = sorted(wanted["impulses"])
    return (not any(differences_of_stability(told, wanted)) and len(impulses) == len(known)
            and not any(apart(one, other, abs(other)) for one, other in zip(impulses, known))
            and not apart(told["amplitude"], wanted.get("amplitude", told["amplitude"]), told["amplitude"]))


def offences(program, name, case, everything):
    scene = DATA / f"{name}.toml"
    wanted = case.get("motion", {})
    coordinates = ["--dofs", ",".join(map(str, range(len(wanted.get("u", [0])))))]
    for method in case["solve"] if everything else case["solve"][:1]:
        record = run(program, "solve", scene, "--method", method, "--json", *coordinates)
        if record["status"] != "converged":
            yield f"{method}: {record['status']}: {record.get('message')}"
        else:
            yield from (f"{method}: {what}" for what in differences(record, wanted))
    for method in case.get("also", []) if everything else []:
        record = run(program, "solve", scene, "--method", method, "--json")
        certificate = record["certificate"]
        if certificate["status"] != "certified" and not record.get("message") and not certificate.get("reason"):
            yield f"{method}: neither certified nor a reason"
    if everything and "orbits" in case:
        found = run(program, "orbits", scene, "--json")
        for one in case["orbits"]:
            if not any(is_orbit(told, one) for told in found):
                yield f"orbits: none like {one}"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("--all", action="store_true")
    asked = parser.parse_args()
    wrong = 0
    for name, case in json.loads((DATA / "cases.json").read_text()).items():
        if case.get("slow") and not asked.all:
            continue
        try:
            found = list(offences(asked.program, name, case, asked.all))
        except AssertionError as failure:
            found = [str(failure)]
        wrong += bool(found)
        for offence in found:
            print(f"{name}: {offence}")
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main())
