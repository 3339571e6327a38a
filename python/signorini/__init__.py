"""Periodic vibrations of structures with contact, computed by the program signorini. docs/python.md is its page."""

from .curve import Curve, Interval, Point, SpecialPoint
from .libraries import MissingLibrary
from .motion import Motion
from .plugin import Option, PythonMethod, method
from .problem import Contact, Load, Problem
from .program import BadInput, Interrupted, NotConverged, ProgramNotFound, SignoriniError, find_program
from .records import frame, load
from .response import Branch, Response, Special
from .results import Event, Orbit, Solution
from .scene import Scene

__version__ = "0.2.0"
__all__ = ["BadInput", "Branch", "Contact", "Curve", "Event", "Interrupted", "Interval", "Load", "MissingLibrary", "Motion", "NotConverged", "Option",
           "Orbit", "Point", "Problem", "ProgramNotFound", "PythonMethod", "Response", "Scene", "SignoriniError", "Solution", "Special", "SpecialPoint",
           "find_program", "frame", "load", "method"]
