#pragma once
// Networks of masses, bars, beams, blocks, rotors, shafts, faces and rings of contacts that must be refused,
// and the one line that refuses each.

#include "tests/problems/scene/malformed_scenes.hpp"

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

constexpr std::string_view kShaft = R"(schema = 1
name = "bad"
[system]
kind = "shaft"
elements = 4
length = 1.0
area = 1.0
inertia = 1.0
young = 1.0
density = 1.0
disc_mass = 1.0
disc_node = 2
bearing_stiffness = 1.0
bearing_damping = 0.1
damping = { beta = 0.01 }
[forcing]
frequency = 1.0
[[contact]]
dofs = [8, 10]
facets = 5
gap = 0.5
[law]
penalty = 100.0
)";

// Its contacts carry no mass: nodes are 0.5 m, 0.2 m and 0.2 m apart.
constexpr std::string_view kBlock = R"(schema = 1
name = "bad"
[system]
kind = "block"
elements = [2, 3, 4]
lengths = [1.0, 0.6, 0.8]
young = 1.0
poisson = 0.3
density = 1.0
damping = { alpha = 0.1, beta = 0.01 }
contact_mass = "massless"
[forcing]
frequency = 1.0
[[forcing.term]]
face = "x+"
direction = "z"
cos = 1.0
[[contact]]
face = "z+"
patch = [[0.4, 1.0], [0.0, 0.2]]
gap = 0.5
)";

inline constexpr Malformed kMalformedStructures[] = {
    // Chains of any topology
    {"GroundOfTooFewSprings", kChain, 7, "springs = [1.0, 1.0, 50.0]\nground_springs = [1.0]",
     "8: system.ground_springs = 1 values (must have one per mass: 3)"},
    {"GroundSpringNegative", kChain, 7, "springs = [1.0, 1.0, 50.0]\nground_springs = [1.0, -1.0, 0.0]",
     "8: system.ground_springs[1] = -1 (must be a number >= 0 [N/m])"},
    {"GroundDampersAsNumber", kChain, 7, "springs = [1.0, 1.0, 50.0]\nground_dampers = 0.1",
     "8: system.ground_dampers = 0.1 (must be a list of numbers >= 0 [N s/m], at least one)"},
    {"LinksOfNothing", kChain, 7, "springs = [1.0, 1.0, 50.0]\nlinks = []",
     "8: system.links = [] (must be a list of [mass, another mass, spring, damper])"},
    {"LinkOfThree", kChain, 7, "springs = [1.0, 1.0, 50.0]\nlinks = [[0, 2, 1.0]]",
     "8: system.links[0] = [0, 2, 1] (must be [mass, another mass, spring, damper])"},
    {"LinkToItself", kChain, 7, "springs = [1.0, 1.0, 50.0]\nlinks = [[0, 2, 1, 0],\n[1, 1, 1, 0]]",
     "9: system.links[1] = [1, 1, 1, 0] (must be [mass, another mass, spring, damper])"},
    {"LinkToNoMass", kChain, 7, "springs = [1.0, 1.0, 50.0]\nlinks = [[0, 3, 1.0, 0.0]]",
     "8: system.links[0][1] = 3 (must be a mass of the chain, 0..2)"},
    {"LinkSpringNegative", kChain, 7, "springs = [1.0, 1.0, 50.0]\nlinks = [[0, 2, -1.0, 0.0]]",
     "8: system.links[0][2] = -1 (must be a number >= 0 [N/m])"},
    {"LinkDamperNotANumber", kChain, 7, "springs = [1.0, 1.0, 50.0]\nlinks = [[0, 2, 1.0, nan]]",
     "8: system.links[0][3] = nan (must be a number >= 0 [N s/m])"},
    {"UnknownChainKey", kChain, 7, "springs = [1.0, 1.0, 50.0]\nground = [1.0, 1.0, 1.0]",
     "8: system.ground = [1, 1, 1] (unknown key; known: kind, masses, dampers, springs, ground_dampers, "
     "ground_springs, links)"},
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
    {"BeamModalTooLarge", kBeam, 5, "elements = 1001",
     "11: system.damping.modal = a system of 2002 coordinates (modal damping takes at most 2000: use alpha "
     "and "
     "beta, or solve the smaller scene that `signorini reduce` makes of this one)"},
    {"BeamModalOfNoModes", kBeam, 11, "damping = { modal = [] }",
     "11: system.damping.modal = [] (must be a damping ratio >= 0 [-], or a list of them)"},
    {"BeamWithMasslessRotation", kBeam, 16, "dof = 3",
     "12: system.contact_mass = massless (needs contacts on deflections only, the even coordinates: "
     "rotations "
     "keep their mass)"},
    {"BeamContactBeyondItsEnd", kBeam, 16, "dof = 4",
     "16: contact[0].dof = 4 (must be a coordinate of the system, 0..3)"},
    {"BeamOfNoBeams", kBeam, 5, "elements = 2\ncount = 0",
     "6: system.count = 0 (must be a whole number, 1..100)"},
    {"BeamContactBeyondTheSecond", kBeam, 16, "dof = 8",
     "16: contact[0].dof = 8 (must be a coordinate of the system, 0..3)"},
    {"BeamContactMassiveWithoutLaw", kBeam, 12, "contact_mass = \"lumped\"",
     "1: law.restitution = missing (required, in 0..1, unless a penalty is given: the contact coordinates "
     "carry mass)"},
    // Blocks
    {"BlockOfTwoElements", kBlock, 5, "elements = [2, 3]",
     "5: system.elements = [2, 3] (must be three whole numbers: bricks along x, y and z)"},
    {"BlockOfNoElementsAlongZ", kBlock, 5, "elements = [2, 3, 0]",
     "5: system.elements[2] = 0 (must be a whole number, 1..100000)"},
    {"BlockTooLarge", kBlock, 5, "elements = [1000, 100, 100]",
     "5: system.elements = 30603000 coordinates (must make at most 1000000)"},
    {"BlockWithoutLengths", kBlock, 6, "",
     "3: system.lengths = missing (must be three positive numbers, along x, y and z [m])"},
    {"BlockOfNoDepth", kBlock, 6, "lengths = [1.0, 0.6, 0.0]",
     "6: system.lengths[2] = 0 (must be a positive number [m])"},
    {"BlockWithoutYoung", kBlock, 7, "young = 0.0",
     "7: system.young = 0 (must be a positive number [N/m^2])"},
    {"BlockIncompressible", kBlock, 8, "poisson = 0.5",
     "8: system.poisson = 0.5 (must be a number between -1 and 0.5 [-])"},
    {"BlockWithoutShearStiffness", kBlock, 8, "poisson = -1",
     "8: system.poisson = -1 (must be a number between -1 and 0.5 [-])"},
    {"BlockWithoutPoisson", kBlock, 8, "",
     "3: system.poisson = missing (must be a number between -1 and 0.5 [-])"},
    {"BlockWhoseStiffnessOverflows", kBlock, 7, "young = 1.7e308",
     "7: system.young = nan (must be a finite number)"},
    {"BlockOfMasslessNodesOnly", kBlock, 5, "elements = [2, 3, 1]",
     "11: system.contact_mass = massless (must leave two nodes without contact behind each other at every "
     "contact, to carry its mass)"},
    {"FaceUnknown", kBlock, 19, "face = \"top\"",
     "19: contact[0].face = \"top\" (must be \"x+\", \"y-\", \"y+\", \"z-\" or \"z+\": x- is clamped)"},
    {"FaceClamped", kBlock, 19, "face = \"x-\"",
     "19: contact[0].face = \"x-\" (must be \"x+\", \"y-\", \"y+\", \"z-\" or \"z+\": x- is clamped)"},
    {"FaceAndDof", kBlock, 19, "face = \"z+\"\ndof = 0",
     "20: contact[0].dof = 0 (must be absent: face is given)"},
    {"FaceOfABar", kBar, 15, "face = \"x+\"",
     "15: contact[0].face = \"x+\" (must be absent: only a block has faces)"},
    {"PatchWithoutFace", kBlock, 19, "dof = 0",
     "20: contact[0].patch = [[0.4, 1], [0, 0.2]] (must be absent: no face is given)"},
    {"PatchOfOneSide", kBlock, 20, "patch = [[0.4, 1.0]]",
     "20: contact[0].patch = [[0.4, 1]] (must be [[from, to], [from, to]], along the two axes of the face "
     "[m])"},
    {"PatchSideOfThree", kBlock, 20, "patch = [[0.4, 1.0], [0.0, 0.1, 0.2]]",
     "20: contact[0].patch[1] = [0, 0.1, 0.2] (must be [[from, to], [from, to]], along the two axes of the "
     "face [m])"},
    {"PatchEndNotANumber", kBlock, 20, "patch = [[0.4, inf], [0.0, 0.2]]",
     "20: contact[0].patch[0][1] = inf (must be a finite number [m])"},
    {"PatchBetweenNodes", kBlock, 20, "patch = [[0.6, 0.9], [0.0, 0.2]]",
     "20: contact[0].patch = [[0.6, 0.9], [0, 0.2]] (must hold a node that can move: they are 0.5 m by 0.2 m "
     "apart)"},
    {"FaceWithoutGap", kBlock, 21, "", "18: contact[0].gap = missing (must be a finite number [m])"},
    {"FaceContactsWithALaw", kBlock, 21, "gap = 0.5\n[law]\nrestitution = 0.5",
     "23: law.restitution = 0.5 (must be absent: no contact coordinate carries mass)"},
    {"LoadOnAFaceOfABar", kBar, 13, "frequency = 1.0\n[[forcing.term]]\nface = \"x+\"\ndirection = \"x\"",
     "15: forcing.term[0].face = \"x+\" (must be absent: only a block has faces)"},
    {"LoadWithoutDirection", kBlock, 16, "",
     "14: forcing.term[0].direction = missing (must be \"x\", \"y\" or \"z\")"},
    {"LoadInNoDirection", kBlock, 16, "direction = \"normal\"",
     "16: forcing.term[0].direction = \"normal\" (must be \"x\", \"y\" or \"z\")"},
    {"LoadOnDofAndFace", kBlock, 16, "direction = \"z\"\ndof = 0",
     "15: forcing.term[0].face = \"x+\" (must be absent: dof is given)"},
    {"DirectionWithoutFace", kBlock, 15, "dof = 0",
     "16: forcing.term[0].direction = \"z\" (must be absent: neither a face nor a group is given)"},
    {"HarmonicAbsurdAfterAFace", kBlock, 17, "cos = 1.0\n[[forcing.term]]\ndof = 0\nharmonic = 10001",
     "20: forcing.term[1].harmonic = 10001 (must be a whole number, 0..10000)"},
    // Shafts
    {"ShaftWithoutDisc", kShaft, 11, "", "3: system.disc_mass = missing (must be a number >= 0 [kg])"},
    {"ShaftWithNegativeDisc", kShaft, 11, "disc_mass = -1",
     "11: system.disc_mass = -1 (must be a number >= 0 [kg])"},
    {"ShaftDiscBeyondItsEnd", kShaft, 12, "disc_node = 5",
     "12: system.disc_node = 5 (must be a node of the shaft, 0..4)"},
    {"ShaftWithoutBearings", kShaft, 13, "bearing_stiffness = 0",
     "13: system.bearing_stiffness = 0 (must be a positive number [N/m])"},
    {"ShaftBearingsThatFeed", kShaft, 14, "bearing_damping = -0.1",
     "14: system.bearing_damping = -0.1 (must be a number >= 0 [N s/m])"},
    {"ShaftWithMorePolarInertiaThanADisc", kShaft, 14, "bearing_damping = 0.1\ndisc_polar_inertia = 0.5",
     "15: system.disc_polar_inertia = 0.5 (must be in 0..0, twice disc_inertia [kg m^2])"},
    {"ShaftWithNegativeDiscInertia", kShaft, 14, "bearing_damping = 0.1\ndisc_inertia = -0.5",
     "15: system.disc_inertia = -0.5 (must be a number >= 0 [kg m^2])"},
    {"ShaftWithContactMass", kShaft, 14, "bearing_damping = 0.1\ncontact_mass = \"massless\"",
     "15: system.contact_mass = \"massless\" (unknown key; known: kind, elements, length, area, inertia, "
     "young, "
     "density, disc_mass, disc_node, disc_inertia, disc_polar_inertia, spin, bearing_stiffness, "
     "bearing_damping, damping)"},
    {"ShaftRingBeyondItsEnd", kShaft, 19, "dofs = [18, 20]",
     "19: contact[0].dofs[1] = 20 (must be a coordinate of the system, 0..19)"},
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
    {"RingWithoutALawBesideAMasslessContact", kChain, 11,
     "dofs = [0, 1]\nfacets = 4\ngap = 0.1\n[[contact]]\ndof = 2",
     "1: law.restitution = missing (required, in 0..1, unless a penalty is given: the contact coordinates "
     "carry mass)"},
};

}  // namespace signorini::test
