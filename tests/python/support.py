"""What the tests of the Python package share: the program under test, and oracles that use none of it."""

import importlib
import os
import sys
import tempfile
import unittest
from pathlib import Path


def installed(module):
    """Whether a module can be imported. A folder of its name without it, as a package that was removed leaves one, is none."""
    try:
        return importlib.import_module(module).__file__ is not None
    except ImportError:
        return False


if not installed("numpy"):
    print("skipped: python3-numpy is not installed")
    sys.exit(77)
import numpy as np  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))
os.environ.setdefault("MPLBACKEND", "Agg")


class TemporaryFolder(unittest.TestCase):
    """A test with a folder of its own, `self.folder`."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="signorini-test-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write(self, name, text, executable=False):
        path = self.folder / name
        path.write_text(text)
        if executable:
            path.chmod(0o755)
        return path


class Oscillator:
    """One mass under cos(w t) with a stop: closed form of the orbit of period T = 2 pi / w with one impact.

    Between impacts x = exp(-a s) (A cos(wd s) + B sin(wd s)) + p(t), s = t - t0, with the particular solution p. From
    x(t0) = x(t0 + T) = g follows A = g - p(t0), B = A (exp(a T) - cos(wd T)) / sin(wd T); x'(t0+) = -e x'(t0 + T-) is then
    a cosine of t0 that equals a constant.
    """

    def __init__(self, mass=1.0, damping=0.1, stiffness=1.0, frequency=2.2, gap=0.2, restitution=1.0):
        self.mass, self.damping, self.frequency, self.gap, self.restitution = mass, damping, frequency, gap, restitution
        self.period = 2 * np.pi / frequency
        self.a = damping / (2 * mass)
        self.wd = np.sqrt(stiffness / mass - self.a**2)
        self.response = 1 / (stiffness - frequency**2 * mass + 1j * frequency * damping)

    def particular(self, t):
        p = self.response * np.exp(1j * self.frequency * t)
        return p.real, (1j * self.frequency * p).real

    def impacts(self):
        """(t0, speed before) of both solutions, admissible or not."""
        a, wd, e, T = self.a, self.wd, self.restitution, self.period
        ratio = (np.exp(a * T) - np.cos(wd * T)) / np.sin(wd * T)
        after, before = -a + wd * ratio, -a + wd * np.exp(-a * T) * (ratio * np.cos(wd * T) - np.sin(wd * T))
        slope = after + e * before  # slope * A + (1 + e) p' = 0, A = g - Re(response exp(i w t0))
        wave = self.response * (-slope + (1 + e) * 1j * self.frequency)
        for sign in (1, -1):
            phase = sign * np.arccos(-slope * self.gap / abs(wave)) - np.angle(wave)
            t0 = phase / self.frequency % T
            p, rate = self.particular(t0)
            yield t0, before * (self.gap - p) + rate

    def motion(self, t0, t):
        a, wd, T = self.a, self.wd, self.period
        s = (t - t0) % T
        A = self.gap - self.particular(t0)[0]
        B = A * (np.exp(a * T) - np.cos(wd * T)) / np.sin(wd * T)
        return np.exp(-a * s) * (A * np.cos(wd * s) + B * np.sin(wd * s)) + self.particular(t)[0]


def receptance(M, D, K, frequency):
    """(K - w^2 M + i w D)^-1"""
    return np.linalg.inv(np.asarray(K) - frequency**2 * np.asarray(M) + 1j * frequency * np.asarray(D))
