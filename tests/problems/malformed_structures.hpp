#pragma once
// Bars, beams, rotors and rings of contacts that must be refused, and the one line that refuses each.

#include "tests/problems/malformed_scenes.hpp"

namespace signorini::test {

// Its tip carries mass.
constexpr std::string_view kBar = R"(schema = 1
name = "bad"
[system]
kind = "bar"
elements = 3
length = 1.0
area = 1.0
young = 1.0
density = 1.0
damping = { alpha = 0.1, beta = 0.01 }
contact_mass = "consistent"
[forcing]
frequency = 1.0
[[contact]]
dof = 2
gap = 0.5
[law]
restitution = 1.0
)";

// Its tip carries none.
constexpr std::string_view kBeam = R"(schema = 1
name = "bad"
[system]
kind = "beam"
elements = 2
length = 1.0
area = 1.0
inertia = 1.0
young = 1.0
density = 1.0
damping = { modal = [0.01, 0.02] }
contact_mass = "massless"
[forcing]
frequency = 1.0
[[contact]]
dof = 2
gap = 0.5
)";

constexpr std::string_view kRotor = R"(schema = 1
name = "bad"
[system]
kind = "rotor"
mass = 1.0
damping = 0.1
stiffness = 1.0
[forcing]
frequency = 1.0
[[contact]]
dofs = [0, 1]
facets = 5
gap = 0.5
[law]
restitution = 1.0
)";

inline constexpr Malformed kMalformedStructures[] = {
    // Finite elements
    {"BarWithoutElements", kBar, 5, "", "3: system.elements = missing (must be a whole number, 1..100000)"},
    {"BarOfNoElements", kBar, 5, "elements = 0",
     "5: system.elements = 0 (must be a whole number, 1..100000)"},
    {"BarOfTooManyElements", kBar, 5, "elements = 100001",
     "5: system.elements = 100001 (must be a whole number, 1..100000)"},
    {"BarOfHalfAnElement", kBar, 5, "elements = 2.5",
     "5: system.elements = 2.5 (must be a whole number, 1..100000)"},
    {"BarWithoutLength", kBar, 6, "length = 0.0", "6: system.length = 0 (must be a positive number [m])"},
    {"BarOfNegativeArea", kBar, 7, "area = -1.0", "7: system.area = -1 (must be a positive number [m^2])"},
    {"BarOfInfiniteYoung", kBar, 8, "young = inf",
     "8: system.young = inf (must be a positive number [N/m^2])"},
    {"BarWhoseStiffnessOverflows", kBar, 8, "young = 1.7e308",
     "8: system.young = inf (must be a finite number)"},
    {"BarOfDensityAsText", kBar, 9, "density = \"steel\"",
     "9: system.density = \"steel\" (must be a positive number [kg/m^3])"},
    {"BarWithInertia", kBar, 9, "density = 1.0\ninertia = 1.0",
     "10: system.inertia = 1 (unknown key; known: kind, elements, length, area, young, density, damping, "
     "contact_mass)"},
    {"BarWithoutDamping", kBar, 10, "",
     "3: system.damping = missing (must be { alpha = .., beta = .. } or { modal = .. })"},
    {"BarDampingAsNumber", kBar, 10, "damping = 0.1",
     "10: system.damping = 0.1 (must be { alpha = .., beta = .. } or { modal = .. })"},
    {"BarDampingOfNothing", kBar, 10, "damping = {}",
     "10: system.damping = {} (must be { alpha = .., beta = .. } or { modal = .. })"},
    {"BarDampingUnknown", kBar, 10, "damping = { gamma = 0.1 }",
     "10: system.damping.gamma = 0.1 (unknown key; known: alpha, beta, modal)"},
    {"BarDampingOfBothSorts", kBar, 10, "damping = { alpha = 0.1, modal = 0.01 }",
     "10: system.damping.modal = 0.01 (must be absent: alpha or beta is given)"},
    {"BarDampingThatFeeds", kBar, 10, "damping = { alpha = -0.1 }",
     "10: system.damping.alpha = -0.1 (must be a number >= 0 [1/s])"},
    {"BarDampingNotANumber", kBar, 10, "damping = { beta = nan }",
     "10: system.damping.beta = nan (must be a number >= 0 [s])"},
    {"BarModalNegative", kBar, 10, "damping = { modal = -0.01 }",
     "10: system.damping.modal = -0.01 (must be a damping ratio >= 0 [-], or a list of them)"},
    {"BarModalOfTooManyModes", kBar, 10, "damping = { modal = [0.1, 0.1, 0.1, 0.1] }",
     "10: system.damping.modal = 4 values (has at most 3 modes)"},
    {"ContactMassUnknown", kBar, 11, "contact_mass = \"none\"",
     "11: system.contact_mass = \"none\" (must be \"consistent\", \"lumped\" or \"massless\")"},
    {"ContactMassAsFlag", kBar, 11, "contact_mass = false",
     "11: system.contact_mass = false (must be \"consistent\", \"lumped\" or \"massless\")"},
    {"RestitutionAtAMasslessBar", kBar, 11, "contact_mass = \"massless\"",
     "18: law.restitution = 1 (must be absent: no contact coordinate carries mass)"},
    {"BarOfMasslessNodesOnly", kBar, 11,
     "contact_mass = \"massless\"\n[[contact]]\ndof = 0\ngap = 1\n[[contact]]\ndof = 1\ngap = 1",
     "11: system.contact_mass = massless (must leave some node besides the clamped one without contact, to "
     "carry the mass)"},
    {"BarContactBeyondItsEnd", kBar, 15, "dof = 3",
     "15: contact[0].dof = 3 (must be a coordinate of the system, 0..2)"},
    {"BeamWithoutInertia", kBeam, 8, "", "3: system.inertia = missing (must be a positive number [m^4])"},
    {"BeamModalRatioAsText", kBeam, 11, "damping = { modal = [0.01, \"x\"] }",
     "11: system.damping.modal[1] = \"x\" (must be a damping ratio >= 0 [-])"},
    {"BeamModalTooLarge", kBeam, 5, "elements = 201",
     "11: system.damping.modal = a system of 402 coordinates (modal damping takes at most 400: use alpha and "
     "beta)"},
    {"BeamModalOfNoModes", kBeam, 11, "damping = { modal = [] }",
     "11: system.damping.modal = [] (must be a damping ratio >= 0 [-], or a list of them)"},
    {"BeamWithMasslessRotation", kBeam, 16, "dof = 3",
     "12: system.contact_mass = massless (needs contacts on deflections only, the even coordinates: "
     "rotations "
     "keep their mass)"},
    {"BeamContactBeyondItsEnd", kBeam, 16, "dof = 4",
     "16: contact[0].dof = 4 (must be a coordinate of the system, 0..3)"},
    {"BeamContactMassiveWithoutLaw", kBeam, 12, "contact_mass = \"lumped\"",
     "1: law.restitution = missing (required, in 0..1, unless a penalty is given: the contact coordinates "
     "carry mass)"},
    // Rotors and rings
    {"RotorWithoutMass", kRotor, 5, "mass = 0.0", "5: system.mass = 0 (must be a positive number [kg])"},
    {"RotorWithMasses", kRotor, 5, "masses = [1.0, 1.0]",
     "5: system.masses = [1, 1] (unknown key; known: kind, mass, damping, stiffness)"},
    {"RingWithoutDofs", kRotor, 11, "",
     "10: contact[0].dofs = missing (must be a pair of different coordinates)"},
    {"RingInOneDirection", kRotor, 11, "dofs = [1, 1]",
     "11: contact[0].dofs = [1, 1] (must be a pair of different coordinates)"},
    {"RingInThreeDirections", kRotor, 11, "dofs = [0, 1, 0]",
     "11: contact[0].dofs = [0, 1, 0] (must be a pair of different coordinates)"},
    {"RingDofOutOfRange", kRotor, 11, "dofs = [0, 2]",
     "11: contact[0].dofs[1] = 2 (must be a coordinate of the system, 0..1)"},
    {"RingWithNormal", kRotor, 11, "normal = [[0, 1.0]]",
     "11: contact[0].normal = [[0, 1]] (must be absent: a ring of facets has dofs, a pair)"},
    {"RingOfTwoFacets", kRotor, 12, "facets = 2",
     "12: contact[0].facets = 2 (must be a whole number, 3..1000)"},
    {"RingWithoutFacets", kRotor, 12, "",
     "10: contact[0].facets = missing (must be a whole number, 3..1000)"},
    {"RingWithoutGap", kRotor, 13, "", "10: contact[0].gap = missing (must be a finite number [m])"},
    {"RingWithTooFewPenalties", kRotor, 15, "penalty = [1.0]",
     "15: law.penalty = 1 values (must be one number, or one per contact: 5)"},
    {"MasslessContactAfterARing", kChain, 11, "dofs = [0, 1]\nfacets = 4\ngap = 0.1\n[[contact]]\ndof = 2",
     "14: contact[1] = massless (beside contacts that carry mass only a penalty law will do: all or none "
     "must "
     "carry mass)"},
};

}  // namespace signorini::test
