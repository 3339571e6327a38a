"""Inputs by a fixed seed: random scenes, scenes made by hand at the edge of what is possible, damaged texts."""

import math
import re

NUMBERS = ["0", "-1", "1", "-0.0", "nan", "inf", "1e999", "1e-320", "1e60", "-1e-60", "2147483648",
           "9223372036854775808", "0x10", "true", '"text"', "[]", "{}", "1979-05-27"]
DIGITS = b"0123456789"
NUMERIC = DIGITS + b".e+-"
TOKEN = re.compile(rb"[A-Za-z0-9_.+-]+")


def damaged(text, others, random):
    """The bytes of `text` after what transmission, editors and people do: bits flip, parts go or come twice, the end is
    missing, a part of another text stands in the middle, a number or a line is another one."""
    text = bytearray(text)
    if random.random() < 0.5:  # one that leaves the text well formed
        replace_token(text, random.choice(others), random)
        return bytes(text)
    for _ in range(random.randint(1, 3)):
        if not text:
            break
        at = random.randrange(len(text))
        length = random.randint(1, min(40, len(text) - at))
        kind = random.randrange(8)
        if kind == 0:
            text[at] ^= 1 << random.randrange(8)
        elif kind == 1:
            del text[at:at + length]
        elif kind == 2:
            text[at:at] = text[at:at + length]
        elif kind == 3:
            del text[at:]
        elif kind == 4:
            other = random.choice(others)
            begin = random.randrange(max(1, len(other)))
            text[at:at] = other[begin:begin + length]
        elif kind == 5:
            lines = text.split(b"\n")
            i, j = random.randrange(len(lines)), random.randrange(len(lines))
            lines[i], lines[j] = lines[j], lines[i]
            text = bytearray(b"\n".join(lines))
        else:
            change_number(text, at, random)
    return bytes(text)


def replace_token(text, other, random):
    """A word or a number becomes one of another text, or a number of another kind."""
    token = random.choice(list(TOKEN.finditer(text)) or [None])
    if token is None:
        return
    words = TOKEN.findall(other) or [b"0"]
    number = random.choice(NUMBERS).encode()
    text[token.start():token.end()] = random.choice(words) if random.random() < 0.6 else number


def change_number(text, at, random):
    """The first number from `at` on becomes another one."""
    begin = next((i for i in range(at, len(text)) if text[i] in DIGITS), None)
    if begin is None:
        return
    end = begin
    while end < len(text) and text[end] in NUMERIC:
        end += 1
    text[begin:end] = random.choice(NUMBERS).encode()


def magnitude(random, low=0.1, high=10.0):
    """Log-uniform; one in forty at the edge of what a scene may hold."""
    if random.random() < 0.025:
        return random.choice([0.0, 1e-60, 1e-30, 1e30, 1e60, -1.0])
    return math.exp(random.uniform(math.log(low), math.log(high)))


def random_system(random):
    """The system table, its number of coordinates, and whether all of them carry mass."""
    kind = random.choice(["sdof", "sdof", "chain", "chain", "bar", "beam", "rotor"])
    if kind in ("sdof", "rotor"):
        text = f"mass = {magnitude(random)}\ndamping = {magnitude(random, 0.001, 1.0)}\n"
        text += f"stiffness = {magnitude(random)}\n"
        return kind, text, 1 if kind == "sdof" else 2
    if kind == "chain":
        size = random.randint(2, 6)
        lists = {key: [magnitude(random, low, high) for _ in range(size)]
                 for key, low, high in (("masses", 0.1, 10), ("dampers", 0.01, 0.5), ("springs", 0.1, 10))}
        if random.random() < 0.2:
            lists["masses"][-1] = 0.0
        return kind, "".join(f"{key} = {values}\n" for key, values in lists.items()), size
    elements = random.randint(1, 12)
    damping = random.choice(["{ modal = 0.05 }", "{ alpha = 0.1, beta = 0.01 }", "{ alpha = 0.0, beta = 0.0 }"])
    text = f"elements = {elements}\nlength = 1.0\narea = 1.0\ndamping = {damping}\n"
    text += f"young = {magnitude(random)}\ndensity = {magnitude(random)}\n"
    if kind == "bar":
        return kind, text + f'contact_mass = "{random.choice(["consistent", "lumped", "massless"])}"\n', elements
    return kind, text + "inertia = 1.0\n", 2 * elements


def random_scene(random, number):
    """A scene that the reader mostly takes, and that has mostly a motion."""
    kind, system, size = random_system(random)
    scene = f'schema = 1\nname = "random-{number}"\n[system]\nkind = "{kind}"\n{system}'
    scene += f"[forcing]\nfrequency = {magnitude(random, 0.2, 5.0)}\n"
    if random.random() < 0.1:
        scene += f"subharmonic = {random.randint(2, 4)}\n"
    for _ in range(random.choice([0, 1, 1, 1, 2])):
        harmonic = random.choice([0, 1, 1, 1, 2, 7])
        sine = "" if harmonic == 0 else f"sin = {random.uniform(-1, 1)}\n"
        scene += f"[[forcing.term]]\ndof = {random.randrange(size)}\nharmonic = {harmonic}\n"
        scene += f"cos = {random.uniform(-2, 2)}\n{sine}"
    for _ in range(random.choice([0, 1, 1, 1, 2, 3])):
        place = f"dof = {random.randrange(size)}"
        if size > 1 and random.random() < 0.4:
            one, other = random.sample(range(size), 2)
            place = f"normal = [[{one}, {random.choice([-1.0, 1.0])}], [{other}, {random.uniform(-1, 1)}]]"
        gap = random.choice([0.0, random.uniform(-0.3, 1.0), magnitude(random, 0.01, 2.0)])
        scene += f"[[contact]]\n{place}\ngap = {gap}\n"
    law = random.choice([f"restitution = {random.uniform(0, 1)}", "restitution = 1", "restitution = 0.0",
                         f"penalty = {magnitude(random, 1.0, 1e4)}",
                         f"penalty = {magnitude(random, 1.0, 1e4)}\ndamping = {magnitude(random, 0.1, 1e2)}", None])
    return (scene + (f"[law]\n{law}\n" if law and "[[contact]]" in scene else "")).encode()


def log_uniform(random, low, high):
    return math.exp(random.uniform(math.log(low), math.log(high)))


def scene_text(name, system, frequency, terms, contacts, law):
    """Terms are (dof, harmonic, cos, sin), contacts (dof, side, gap)."""
    text = f'schema = 1\nname = "{name}"\n[system]\n{system}\n[forcing]\nfrequency = {frequency:.6g}\n'
    for dof, harmonic, cosine, sine in terms:
        text += f"[[forcing.term]]\ndof = {dof}\nharmonic = {harmonic}\ncos = {cosine:.6g}\nsin = {sine:.6g}\n"
    for dof, side, gap in contacts:
        text += f"[[contact]]\nnormal = [[{dof}, {side}]]\ngap = {gap:.6g}\n"
    return text + (f"[law]\n{law}\n" if law else "")


def mass_before_stops(random, number):
    """One mass on a spring with stops of any law, gaps mostly within reach of its contact-free motion."""
    damping, frequency = log_uniform(random, 0.02, 0.3), random.uniform(0.4, 3.2)
    reach = 1.0 / math.hypot(1.0 - frequency**2, damping * frequency)
    gap = random.uniform(0.05, 0.9) * reach * (1.0 if random.random() < 0.85 else random.choice([-0.3, 1.3]))
    law = f"restitution = {random.choice([0.0, 0.3, 0.5, 0.7, 0.8, 0.9, 1.0, 1.0])}"
    terms, contacts, kind = [(0, 1, 1.0, 0.0)], [(0, 1.0, gap)], number % 15
    if kind in (8, 9, 13):
        contacts = [(0, 1.0, abs(gap)), (0, -1.0, random.uniform(0.05, 0.9) * reach)]
    if kind in (10, 11, 12, 13, 14):
        law = f"penalty = {log_uniform(random, 1.0, 1e4 if kind < 13 else 1e3):.6g}"
    if kind == 14:
        law += f"\ndamping = {log_uniform(random, 0.05, 5.0):.6g}" if number % 2 else ""
        terms += [(0, 2, random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)), (0, 3, random.uniform(-0.3, 0.3), 0.0)]
    system = f'kind = "sdof"\nmass = 1.0\ndamping = {damping:.6g}\nstiffness = 1.0'
    return scene_text(f"mass-{number:03}", system, frequency, terms, contacts, law)


def chain_between_stops(random, number):
    """One to four masses with light damping, two stops: on both sides of the last one or also of another, rigid or springs."""
    size = random.choice([1, 1, 2, 2, 3, 4])
    masses, springs = ([log_uniform(random, 0.5, 2.0) for _ in range(size)] for _ in range(2))
    loss = log_uniform(random, 0.004, 0.06)
    rows = "".join(f"\n{key} = {[round(value, 5) for value in values]}" for key, values in (
        ("masses", masses), ("dampers", [loss * spring for spring in springs]), ("springs", springs)))
    second = (size - 1, -1.0) if size == 1 or random.random() < 0.5 else (random.randrange(size - 1), random.choice([1.0, -1.0]))
    gaps = [log_uniform(random, 0.05, 1.2) for _ in range(2)]
    law = f"restitution = {random.uniform(0.6, 1.0):.4g}" if random.random() < 0.6 else f"penalty = {log_uniform(random, 20.0, 200.0):.4g}"
    return scene_text(f"chain-{number:03}", f'kind = "chain"{rows}', random.uniform(0.4, 3.5), [(random.randrange(size), 1, 1.0, 0.0)],
                      [(size - 1, 1.0, gaps[0]), (*second, gaps[1])], law)


def chain_or_beam(random, number):
    """A chain of two to six masses, the last one massless now and then, or a cantilever of three to eight elements, with a
    stop at its end: rigid or a spring."""
    law = f"restitution = {random.choice([0.0, 0.5, 0.8, 1.0])}"
    if number % 3 == 2:
        elements = random.randint(3, 8)
        tip = 2 * (elements - 1)
        if number % 2:
            law = f"penalty = {log_uniform(random, 5.0, 1e3):.6g}"
        system = (f'kind = "beam"\nelements = {elements}\nlength = 1.0\narea = 1.0\ninertia = 1.0\nyoung = 1.0\n'
                  f"density = 1.0\ndamping = {{ modal = [{random.uniform(0.02, 0.08):.4g}, 0.1, 0.3] }}")
        return scene_text(f"beam-{number:03}", system, random.uniform(2.0, 6.0), [(tip, 1, 0.6, 0.0)],
                          [(tip, 1.0, random.uniform(0.02, 0.12))], law)
    size = random.randint(2, 6)
    masses = [random.uniform(0.5, 2.0) for _ in range(size)]
    springs, dampers = ([random.uniform(*bounds) for _ in masses] for bounds in ((0.8, 1.5), (0.05, 0.2)))
    if number % 4 == 1:
        law = f"penalty = {log_uniform(random, 2.0, 1e3):.6g}"
    if number % 4 == 3:
        masses[-1], law = 0.0, None
    rows = "".join(f"\n{key} = {[round(value, 5) for value in values]}"
                   for key, values in (("masses", masses), ("dampers", dampers), ("springs", springs)))
    loaded = random.randrange(size - (masses[-1] == 0.0))
    return scene_text(f"chain-{number:03}", f'kind = "chain"{rows}', random.uniform(0.4, 1.8), [(loaded, 1, 1.0, 0.0)],
                      [(size - 1, 1.0, random.uniform(0.2, 1.2))], law)


def loose_or_mixed(random, number):
    """Parts that no spring holds, stops between two bodies, and contacts of different laws: a mass between two stops, a gear pair,
    a body on a table that shakes, two laws on a chain, an impact damper, a free mass between two sprung ones."""
    kind, frequency = number % 6, random.uniform(0.5, 2.5)
    rigid = lambda: f"restitution = {random.choice([0.0, 0.3, 0.5, 0.7, 0.8, 0.9])}"
    spring = lambda: f"penalty = {log_uniform(random, 2.0, 1e3):.6g}"
    same = random.choice([rigid, spring])()
    either = lambda: [(same, same), (rigid(), spring()), (rigid(), rigid())][number // 6 % 3]
    masses, dampers, springs = ([random.uniform(0.5, 2.0) for _ in range(3)], [log_uniform(random, 0.05, 0.4) for _ in range(3)],
                                [random.uniform(0.8, 1.5) for _ in range(3)])
    terms, gaps, laws = [(0, 1, 1.0, 0.0)], [random.uniform(0.05, 0.8) for _ in range(2)], either()
    between = lambda i, j: f"[[{i}, 1.0], [{j}, -1.0]]"
    size, places = 2, (between(0, 1), between(1, 0))
    if kind == 0:
        size, springs[0], places = 1, 0.0, ("[[0, 1.0]]", "[[0, -1.0]]")
    elif kind == 1:  # a mean torque through the teeth
        torque, springs = random.uniform(0.1, 0.6), [0.0, 0.0]
        terms = [(0, 0, torque, 0.0), (1, 0, -torque, 0.0), (0, 1, 0.6, 0.2)]
    elif kind == 2:
        size, springs[0], places = 1, 0.0, ("[[0, 1.0]]",)
        terms = [(0, 0, random.uniform(0.3, 1.5), 0.0), (0, 1, 1.0, 0.0)]
    elif kind == 3:
        size, places = random.randint(2, 3), ("[[1, 1.0]]", random.choice(["[[1, -1.0]]", "[[0, 1.0]]", between(0, 1)]))
        laws = random.choice([(rigid(), spring()), (rigid(), rigid())])
    elif kind == 4:
        masses[1], springs[1] = random.uniform(0.05, 0.3), 0.0
    else:
        size, springs[1:], dampers[1:], places = 3, [0.0, 0.0], [0.0, 0.0], (between(0, 1), between(1, 2))
    rows = {"masses": masses, "dampers": dampers, "springs": springs,
            "ground_springs": [0.0, 0.0, 1.2 if kind == 5 else 0.0],  # the one in the middle is free
            "ground_dampers": [0.0, 0.1, 0.1] if kind in (1, 5) else [0.0] * 3}
    system = 'kind = "chain"' + "".join(f"\n{key} = {[round(value, 5) for value in row[:size]]}" for key, row in rows.items())
    text = scene_text(f"loose-{number:03}", system, frequency, terms, [], None)
    for place, gap, law in zip(places, gaps, laws):
        text += f"[[contact]]\nnormal = {place}\ngap = {gap:.6g}\n{law}\n"
    return text


def one_mass(mass=1.0, damping=0.1, stiffness=1.0, frequency=2.2, force="dof = 0\ncos = 1.0\n", gaps=(0.2,),
             law="restitution = 1.0", more=""):
    contacts = "".join(f"[[contact]]\ndof = 0\ngap = {gap}\n" for gap in gaps)
    terms = f"[[forcing.term]]\n{force}" if force else ""
    return (f'schema = 1\nname = "scene"\n[system]\nkind = "sdof"\nmass = {mass}\ndamping = {damping}\n'
            f"stiffness = {stiffness}\n[forcing]\nfrequency = {frequency}\n{more}{terms}{contacts}[law]\n{law}\n")


def chain(size, law="restitution = 0.8", gap=0.3, contacts=None, ground=None, masses=None):
    masses = masses or [1.0] * size
    ground = f"ground_springs = {ground}\n" if ground else ""
    touching = contacts if contacts is not None else range(size)
    tables = "".join(f"[[contact]]\ndof = {dof}\ngap = {gap}\n" for dof in touching)
    return (f'schema = 1\nname = "scene"\n[system]\nkind = "chain"\nmasses = {masses}\ndampers = {[0.05] * size}\n'
            f"springs = {[1.0] * size}\n{ground}[forcing]\nfrequency = 0.7\n[[forcing.term]]\ndof = {size - 1}\n"
            f"cos = 0.4\n{tables}[law]\n{law}\n")


def hand_made_scenes():
    """Scenes at the edge of mechanics, by name; each is refused with a reason, or its answers are true."""
    opposite = "[[contact]]\ndof = 0\ngap = {0}\n[[contact]]\nnormal = [[0, -1.0]]\ngap = {0}\n"
    two_sided = lambda gap: one_mass(gaps=()).replace("[law]", opposite.format(gap) + "[law]")
    rotor = ('schema = 1\nname = "scene"\n[system]\nkind = "rotor"\nmass = 1.0\ndamping = 0.2\nstiffness = 1.0\n'
             "[forcing]\nfrequency = 1.5\n[[forcing.term]]\ndof = 0\ncos = 1.0\n[[forcing.term]]\ndof = 1\nsin = 1.0\n[[contact]]\n"
             "dofs = [0, 1]\nfacets = {}\ngap = 0.3\n[law]\npenalty = 50.0\n")
    return {
        "no-stiffness": one_mass(stiffness=0.0),
        "gravity-ball": one_mass(stiffness=0.0, damping=0.0, frequency=3.0, gaps=(0.0,),
                                 law="restitution = 0.5", force="dof = 0\nharmonic = 0\ncos = 9.81\n[[forcing.term]]\ndof = 0\ncos = 5.0\n"),
        "undamped-resonance": one_mass(damping=0.0, frequency=1.0),
        "undamped-resonance-no-stop": one_mass(damping=0.0, frequency=1.0, gaps=(1e9,)),
        "hundred-contacts": chain(100, gap=0.4),
        "stiff-penalty": one_mass(law="penalty = 1e12"),
        "stiffest-penalty": one_mass(law="penalty = 1e60"),
        "softest-penalty": one_mass(law="penalty = 1e-60"),
        "harmonic-10000": one_mass(force="dof = 0\nharmonic = 10000\ncos = 1e6\n"),
        "overdamped": one_mass(damping=200.0),
        "overdamped-closed": one_mass(damping=200.0, gaps=(-1.0,)),
        "no-force": one_mass(force=""),
        "no-force-preload": one_mass(force="", gaps=(-0.5,), law="restitution = 0.5"),
        "permanent-contact": one_mass(gaps=(-50.0,), law="restitution = 0.5"),
        "duplicated-stop": one_mass(gaps=(0.2, 0.2), law="restitution = 0.8"),
        "two-of-three-alike": one_mass(stiffness=0.29, damping=0.0014, frequency=1.64, gaps=(-0.07, 0.0, 0.0), law="restitution = 0.0"),
        "twenty-stops": one_mass(gaps=(0.2,) * 20, law="restitution = 0.8"),
        "two-gaps-zero": two_sided(0.0),
        "crossed-stops": two_sided(-0.1),
        "narrow-slot": two_sided(1e-9),
        "nearly-elastic": one_mass(law="restitution = 0.999999999"),
        "nearly-plastic": one_mass(law="restitution = 1e-9"),
        "chattering": one_mass(gaps=(0.0,), law="restitution = 0.9", frequency=0.05),
        "slowest": one_mass(frequency=1e-20),
        "fastest": one_mass(frequency=1e20),
        "slow": one_mass(frequency=1e-6),
        "fast": one_mass(frequency=1e6),
        "subharmonic-64": one_mass(more="subharmonic = 64\n"),
        "rigid-mode": chain(3).replace("springs = [1.0,", "springs = [0.0,").replace("dampers = [0.05,", "dampers = [0.0,"),
        "mass-ratio": chain(2, masses=[1e12, 1.0], contacts=[1]),
        "massless-tip": chain(3, law="", masses=[1.0, 1.0, 0.0], contacts=[2]).replace("[law]\n", ""),
        "mixed-mass": chain(3, masses=[1.0, 1.0, 0.0], contacts=[1, 2]),
        "tiny-lengths": one_mass(force="dof = 0\ncos = 1e-58\n", gaps=(2e-59,)),
        "huge-lengths": one_mass(force="dof = 0\ncos = 1e58\n", gaps=(2e57,)),
        "far-origin": one_mass(gaps=(1000.2,), force="dof = 0\ncos = 1.0\n[[forcing.term]]\ndof = 0\nharmonic = 0\n"
                                                     "cos = 1000.0\n"),
        "thousand-facets": rotor.format(1000),
        "free-rotor": rotor.format(3).replace("stiffness = 1.0", "stiffness = 0.0").replace("damping = 0.2", "damping = 0.015"),
        "three-facets": rotor.format(3),
        "grazing": one_mass(gaps=(1.0 / math.hypot(2.2 ** 2 - 1.0, 0.22),)),
        "two-harmonics-cancel": one_mass(force="dof = 0\ncos = 1.0\n[[forcing.term]]\ndof = 0\ncos = -1.0\n"),
        "sixty-four-stops": chain(64, law="penalty = 1e6", gap=0.01),
        "restitution-below-zero": one_mass(law="restitution = -0.1"),
        "gap-not-finite": one_mass(gaps=("inf",)),
        "mass-negative": one_mass(mass=-1.0),
        "no-mass": one_mass(mass=0.0),
    }
