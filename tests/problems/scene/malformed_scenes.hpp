#pragma once
// Scene files that must be refused, and the one line that refuses each.

#include <ostream>
#include <string_view>

namespace signorini::test {

constexpr std::string_view kOscillator = R"(schema = 1
name = "bad"
title = "A scene to spoil"
tags = ["test"]
[system]
kind = "sdof"
mass = 1.0
damping = 0.1
stiffness = 1.0
[forcing]
frequency = 2.0
subharmonic = 1
[[forcing.term]]
dof = 0
harmonic = 1
cos = 1.0
sin = 0.0
[[contact]]
dof = 0
gap = 0.2
[law]
restitution = 1.0
)";

constexpr std::string_view kContactFree = R"(schema = 1
name = "bad"
[system]
kind = "sdof"
mass = 1.0
damping = 0.1
stiffness = 1.0
[forcing]
frequency = 1.0
)";

// Its contact node carries no mass, hence no law.
constexpr std::string_view kChain = R"(schema = 1
name = "bad"
[system]
kind = "chain"
masses = [1.0, 2.0, 0.0]
dampers = [0.1, 0.1, 0.0]
springs = [1.0, 1.0, 50.0]
[forcing]
frequency = 1.0
[[contact]]
normal = [[2, 1.0]]
gap = 0.5
)";

struct Malformed {
  std::string_view label;
  std::string_view scene;        ///< the sound scene that is spoiled
  int line = 0;                  ///< replaced; 0: the whole text
  std::string_view replacement;  ///< one line or several
  std::string_view message;      ///< after "bad.toml:"
};

// Test names must not depend on addresses.
inline void PrintTo(const Malformed& malformed, std::ostream* stream) { *stream << malformed.label; }

inline constexpr Malformed kMalformed[] = {
    // The whole file
    {"Empty", kOscillator, 0, "", "1: schema = missing (must be 1)"},
    {"OnlyAComment", kOscillator, 0, "# nothing\n", "1: schema = missing (must be 1)"},
    {"SchemaOfTomorrow", kOscillator, 1, "schema = 2", "1: schema = 2 (must be 1)"},
    {"SchemaAsText", kOscillator, 1, "schema = \"1\"", "1: schema = \"1\" (must be 1)"},
    {"NoSchema", kOscillator, 1, "", "1: schema = missing (must be 1)"},
    {"UnknownTopKey", kOscillator, 3, "titel = \"x\"",
     "3: titel = \"x\" (unknown key; known: schema, name, title, reference, tags, system, forcing, base, "
     "contact, "
     "law)"},
    {"KeyWithALineBreak", kOscillator, 3, R"("a\nb" = 1)",
     "3: a\\nb = 1 (unknown key; known: schema, name, title, reference, tags, system, forcing, base, "
     "contact, "
     "law)"},
    // Header
    {"NoName", kOscillator, 2, "",
     "1: name = missing (must be a name in lower-kebab-case, such as \"sdof-stop\", of at most 64 "
     "characters)"},
    {"NameWithCapitals", kOscillator, 2, "name = \"Sdof-stop\"",
     "2: name = \"Sdof-stop\" (must be a name in lower-kebab-case, such as \"sdof-stop\", of at most 64 "
     "characters)"},
    {"NameWithUnderscore", kOscillator, 2, "name = \"sdof_stop\"",
     "2: name = \"sdof_stop\" (must be a name in lower-kebab-case, such as \"sdof-stop\", of at most 64 "
     "characters)"},
    {"NameWithTrailingDash", kOscillator, 2, "name = \"sdof-\"",
     "2: name = \"sdof-\" (must be a name in lower-kebab-case, such as \"sdof-stop\", of at most 64 "
     "characters)"},
    {"NameWithPath", kOscillator, 2, "name = \"../x\"",
     "2: name = \"../x\" (must be a name in lower-kebab-case, such as \"sdof-stop\", of at most 64 "
     "characters)"},
    {"NameAsNumber", kOscillator, 2, "name = 3",
     "2: name = 3 (must be a name in lower-kebab-case, such as \"sdof-stop\", of at most 64 characters)"},
    {"TitleOfTwoLines", kOscillator, 3, R"(title = "one\ntwo")",
     "3: title = \"one\\ntwo\" (must be one line of text)"},
    {"TagsAsText", kOscillator, 4, "tags = \"impact\"",
     "4: tags = \"impact\" (must be a list of words; left out if there is none)"},
    {"TagAsNumber", kOscillator, 4, "tags = [\"impact\",\n 1]", "5: tags[1] = 1 (must be a word)"},
    {"NoTags", kOscillator, 4, "tags = []",
     "4: tags = [] (must be a list of words; left out if there is none)"},
    {"NoContactsByEmptyList", kContactFree, 2, "name = \"bad\"\ncontact = []",
     "3: contact = [] (must be [[contact]] tables; left out if there is none)"},
    {"ContactsAsNumbers", kContactFree, 2, "name = \"bad\"\ncontact = [1]",
     "3: contact[0] = 1 (must be a table)"},
    {"LawAsNumber", kContactFree, 2, "name = \"bad\"\nlaw = 1.0",
     "3: law = 1 (must be a table with restitution or penalty)"},
    // System
    {"NoSystem", kContactFree, 3, "[forcing.system]",
     "1: system = missing (must be a table with kind = \"sdof\", \"chain\", \"bar\", \"beam\", \"block\", "
     "\"mesh\", "
     "\"rotor\", \"shaft\" or \"matrices\")"},
    {"NoKind", kOscillator, 6, "",
     "5: system.kind = missing (must be \"sdof\", \"chain\", \"bar\", \"beam\", \"block\", \"mesh\", "
     "\"rotor\", "
     "\"shaft\" or \"matrices\")"},
    {"KindOfTomorrow", kOscillator, 6, "kind = \"shell\"",
     "6: system.kind = \"shell\" (must be \"sdof\", \"chain\", \"bar\", \"beam\", \"block\", \"mesh\", "
     "\"rotor\", \"shaft\" or \"matrices\")"},
    {"UnknownKind", kOscillator, 6, "kind = \"SDOF\"",
     "6: system.kind = \"SDOF\" (must be \"sdof\", \"chain\", \"bar\", \"beam\", \"block\", \"mesh\", "
     "\"rotor\", "
     "\"shaft\" or \"matrices\")"},
    {"KeyOfAnotherKind", kOscillator, 7, "masses = [1.0]",
     "7: system.masses = [1] (unknown key; known: kind, mass, damping, stiffness)"},
    {"NoMass", kOscillator, 7, "", "5: system.mass = missing (must be a positive number [kg])"},
    {"NegativeMass", kOscillator, 7, "mass = -1.0", "7: system.mass = -1 (must be a positive number [kg])"},
    {"ZeroMass", kOscillator, 7, "mass = 0", "7: system.mass = 0 (must be a positive number [kg])"},
    {"MassAsText", kOscillator, 7, "mass = \"1 kg\"",
     "7: system.mass = \"1 kg\" (must be a positive number [kg])"},
    {"MassAsDate", kOscillator, 7, "mass = 2020-02-29",
     "7: system.mass = 2020-02-29 (must be a positive number [kg])"},
    {"MassAsTable", kOscillator, 7, "mass = { value = 1.0 }",
     "7: system.mass = {value = 1} (must be a positive number [kg])"},
    {"MassNotANumber", kOscillator, 7, "mass = nan", "7: system.mass = nan (must be a positive number [kg])"},
    {"DampingInfinite", kOscillator, 8, "damping = inf",
     "8: system.damping = inf (must be a number >= 0 [N s/m])"},
    {"NegativeDamping", kOscillator, 8, "damping = -0.1",
     "8: system.damping = -0.1 (must be a number >= 0 [N s/m])"},
    {"NegativeStiffness", kOscillator, 9, "stiffness = -1",
     "9: system.stiffness = -1 (must be a number >= 0 [N/m])"},
    {"StiffnessAsFlag", kOscillator, 9, "stiffness = true",
     "9: system.stiffness = true (must be a number >= 0 [N/m])"},
    {"NoMasses", kChain, 5, "masses = []",
     "5: system.masses = [] (must be a list of numbers >= 0 [kg], at least one)"},
    {"OneMassAsNumber", kChain, 5, "masses = 1.0",
     "5: system.masses = 1 (must be a list of numbers >= 0 [kg], at least one)"},
    {"NegativeMassInChain", kChain, 5, "masses = [1.0,\n -2.0, 0.0]",
     "6: system.masses[1] = -2 (must be a number >= 0 [kg])"},
    {"TooFewDampers", kChain, 6, "dampers = [0.1, 0.1]",
     "6: system.dampers = 2 values (must have one per mass: 3)"},
    {"TooManySprings", kChain, 7, "springs = [1, 1, 1, 1]",
     "7: system.springs = 4 values (must have one per mass: 3)"},
    {"NoSprings", kChain, 7, "",
     "3: system.springs = missing (must be a list of numbers >= 0 [N/m], at least one)"},
    {"SpringNotANumber", kChain, 7, "springs = [1.0, nan, 1.0]",
     "7: system.springs[1] = nan (must be a number >= 0 [N/m])"},
    {"NestedSprings", kChain, 7, "springs = [[1.0, 1.0, 1.0]]",
     "7: system.springs[0] = [1, 1, 1] (must be a number >= 0 [N/m])"},
    {"AllMassless", kChain, 5, "masses = [0.0, 0.0, 0.0]",
     "5: system.masses = 0 (some coordinate must carry mass)"},
    {"SpringsThatOverflow", kChain, 7, "springs = [1.7e308, 1.7e308, 1.0]",
     "7: system.springs = inf (must be a finite number)"},
    {"LooseNode", kChain, 7, "springs = [1.0, 1.0, 0.0]",
     "3: system = structure with a loose coordinate (every motion must meet a mass, a damper or a spring)"},
    // Forcing
    {"NoFrequency", kOscillator, 11, "",
     "10: forcing.frequency = missing (must be a positive number [rad/s])"},
    {"ZeroFrequency", kOscillator, 11, "frequency = 0",
     "11: forcing.frequency = 0 (must be a positive number [rad/s])"},
    {"NegativeFrequency", kOscillator, 11, "frequency = -2.0",
     "11: forcing.frequency = -2 (must be a positive number [rad/s])"},
    {"FrequencyAsList", kOscillator, 11, "frequency = [2.0]",
     "11: forcing.frequency = [2] (must be a positive number [rad/s])"},
    {"SubharmonicZero", kOscillator, 12, "subharmonic = 0",
     "12: forcing.subharmonic = 0 (must be a whole number, 1..64)"},
    {"SubharmonicTooHigh", kOscillator, 12, "subharmonic = 65",
     "12: forcing.subharmonic = 65 (must be a whole number, 1..64)"},
    {"SubharmonicBroken", kOscillator, 12, "subharmonic = 1.5",
     "12: forcing.subharmonic = 1.5 (must be a whole number)"},
    {"SubharmonicBeyondInt", kOscillator, 12, "subharmonic = 4294967297",
     "12: forcing.subharmonic = 4294967297 (must be a whole number)"},
    {"UnknownForcingKey", kOscillator, 12, "phase = 0.0",
     "12: forcing.phase = 0 (unknown key; known: frequency, frequency_hz, subharmonic, term, unbalance)"},
    {"TermAsTable", kOscillator, 13, "[forcing.term]",
     "13: forcing.term = {dof = 0, harmonic = 1, cos = 1, sin = 0} (must be [[forcing.term]] tables; left "
     "out if there "
     "is none)"},
    {"TermWithoutDof", kOscillator, 14, "",
     "13: forcing.term[0].dof = missing (must be a coordinate of the system, 0..0)"},
    {"TermDofOutOfRange", kOscillator, 14, "dof = 1",
     "14: forcing.term[0].dof = 1 (must be a coordinate of the system, 0..0)"},
    {"TermDofNegative", kOscillator, 14, "dof = -1",
     "14: forcing.term[0].dof = -1 (must be a coordinate of the system, 0..0)"},
    {"TermDofBroken", kOscillator, 14, "dof = 0.0",
     "14: forcing.term[0].dof = 0.0 (must be a coordinate of the system, 0..0: 0, without a decimal point)"},
    {"DecimalComma", kOscillator, 20, "gap = 0,2",
     "20: file = not TOML (must be valid TOML 1.0; Error while parsing key-value pair: expected a comment or "
     "whitespace, saw ','; a decimal comma: write a point, as in 1.5)"},
    {"DecimalCommaInline", kOscillator, 17, "x = { gap = 0,2 }",
     "17: file = not TOML (must be valid TOML 1.0; Error while parsing key-value pair: expected '=', saw "
     "'}'; a decimal comma: write a point, as in 1.5)"},
    {"MinusOfATextProcessor", kOscillator, 20,
     "gap = \xE2\x88\x92"
     "0.2",
     "20: file = not TOML (must be valid TOML 1.0; Error while parsing value: could not determine value "
     "type; the minus sign is one of a text processor: write -)"},
    {"LawInAContact", kOscillator, 20, "gap = 0.2\nlaw = { restitution = 0.5 }",
     "21: contact[0].law = {restitution = 0.5} (must be left out: restitution, penalty, damper and massless "
     "are keys of the contact itself, beside gap; a table [law] is the default of all contacts)"},
    {"TwoFrequencies", kOscillator, 11, "frequency = 1.0\nfrequency_hz = 0.2",
     "12: forcing.frequency_hz = 0.2 (must be absent: frequency is given)"},
    {"HarmonicNegative", kOscillator, 15, "harmonic = -1",
     "15: forcing.term[0].harmonic = -1 (must be a whole number, 0..10000)"},
    {"HarmonicAbsurd", kOscillator, 15, "harmonic = 10001",
     "15: forcing.term[0].harmonic = 10001 (must be a whole number, 0..10000)"},
    {"LoadNotANumber", kOscillator, 16, "cos = nan",
     "16: forcing.term[0].cos = nan (must be a finite number)"},
    {"UnknownTermKey", kOscillator, 17, "phase = 0.5",
     "17: forcing.term[0].phase = 0.5 (unknown key; known: dof, face, group, direction, harmonic, "
     "frequency, frequency_hz, cos, sin, omega_power, samples, file, harmonics)"},
    // Contacts
    {"ContactAsTable", kOscillator, 18, "[contact]",
     "18: contact = {dof = 0, gap = 0.2} (must be [[contact]] tables; left out if there is none)"},
    {"ContactWithoutDirection", kOscillator, 19, "",
     "18: contact[0].dof = missing (must be a coordinate of the system, 0..0)"},
    {"ContactDofOutOfRange", kOscillator, 19, "dof = 7",
     "19: contact[0].dof = 7 (must be a coordinate of the system, 0..0)"},
    {"DofAndNormal", kOscillator, 19, "dof = 0\nnormal = [[0, 1.0]]",
     "20: contact[0].normal = [[0, 1]] (must be absent: dof is given)"},
    {"NoGap", kOscillator, 20, "", "18: contact[0].gap = missing (must be a finite number [m])"},
    {"GapInfinite", kOscillator, 20, "gap = inf", "20: contact[0].gap = inf (must be a finite number [m])"},
    {"UnknownContactKey", kOscillator, 20, "gap = 0.2\nfriction = 0.3",
     "21: contact[0].friction = 0.3 (unknown key; known: dof, normal, between, side, dofs, facets, face, "
     "patch, "
     "group, direction, gap, clearance, gap_term, centre_term, restitution, penalty, damper, damping, "
     "massless)"},
    {"EmptyNormal", kChain, 11, "normal = []",
     "11: contact[0].normal = [] (must be a list of pairs [dof, coefficient])"},
    {"FlatNormal", kChain, 11, "normal = [2, 1.0]",
     "11: contact[0].normal[0] = 2 (must be a pair [dof, coefficient])"},
    {"NormalOfTriples", kChain, 11, "normal = [[2, 1.0, 3.0]]",
     "11: contact[0].normal[0] = [2, 1, 3] (must be a pair [dof, coefficient])"},
    {"ZeroNormal", kChain, 11, "normal = [[2, 0.0], [1, 0]]",
     "11: contact[0].normal = zero vector (needs a nonzero coefficient)"},
    {"NormalNamesACoordinateTwice", kChain, 11, "normal = [[2, 0.5],\n [2, 0.5]]",
     "12: contact[0].normal[1][0] = 2 (must name each coordinate once)"},
    {"NormalDofOutOfRange", kChain, 11, "normal = [[3, 1.0]]",
     "11: contact[0].normal[0][0] = 3 (must be a coordinate of the system, 0..2)"},
    {"NormalCoefficientNotANumber", kChain, 11, "normal = [[2, nan]]",
     "11: contact[0].normal[0][1] = nan (must be a finite number)"},
    // Law
    {"NoRestitution", kOscillator, 22, "", "21: law = {} (must hold restitution or penalty, or be left out)"},
    {"LawWithoutImpactLaw", kChain, 12, "gap = 0.5\n[law]",
     "13: law = {} (must hold restitution or penalty, or be left out)"},
    {"RestitutionAboveOne", kOscillator, 22, "restitution = 1.01",
     "22: law.restitution = 1.01 (must be in 0..1)"},
    {"RestitutionNegative", kOscillator, 22, "restitution = -0.5",
     "22: law.restitution = -0.5 (must be in 0..1)"},
    {"RestitutionNotANumber", kOscillator, 22, "restitution = nan",
     "22: law.restitution = nan (must be in 0..1)"},
    {"RestitutionAsText", kOscillator, 22, "restitution = \"elastic\"",
     "22: law.restitution = \"elastic\" (must be in 0..1)"},
    {"RestitutionAndPenalty", kOscillator, 22, "restitution = 1.0\npenalty = 1e6",
     "23: law.penalty = 1000000 (must be absent: restitution is given)"},
    {"PenaltyZero", kOscillator, 22, "penalty = 0", "22: law.penalty = 0 (must be a positive number [N/m])"},
    {"PenaltyNegativeInList", kOscillator, 22, "penalty = [\n-1.0]",
     "23: law.penalty[0] = -1 (must be a positive number [N/m])"},
    {"PenaltyEmpty", kOscillator, 22, "penalty = []",
     "22: law.penalty = [] (must be a positive number [N/m], or a list of them)"},
    {"PenaltyOfWrongSize", kOscillator, 22, "penalty = [1.0, 2.0]",
     "22: law.penalty = 2 values (must be one number, or one per contact: 1)"},
    {"UnknownLawKey", kOscillator, 22, "friction = 0.3",
     "22: law.friction = 0.3 (unknown key; known: restitution, penalty, damping)"},
    {"RestitutionWithoutMass", kChain, 12, "gap = 0.5\n[law]\nrestitution = 0.5",
     "14: law.restitution = 0.5 (must be absent: no contact coordinate carries mass)"},
    {"MassiveWithoutLaw", kChain, 11, "normal = [[1, 1.0]]",
     "1: law.restitution = missing (required, in 0..1, unless a penalty is given: the contact coordinates "
     "carry mass)"},
    {"MixedMass", kChain, 12, "gap = 0.5\n[[contact]]\ndof = 0\ngap = 0.1\n[law]\nrestitution = 1",
     "10: contact[0] = massless (needs massless = true beside contacts that carry mass: no restitution is "
     "for "
     "it)"},
    {"PartlyMasslessNormal", kChain, 11,
     "normal = [[2, 1.0], [1, -1.0]]\ngap = 0.1\n[law]\nrestitution = 1\n[[contact]]\ndof = 0",
     "11: contact[0].normal = partly massless (under a restitution law every coordinate of a normal must "
     "carry mass)"},
    // A scene without contact
    {"NoForcing", kContactFree, 8, "[[contact]]",
     "1: forcing = missing (must be a table with the frequency)"},
    {"SystemAsText", kContactFree, 3, "system = 1\n[forcing.other]",
     "3: system = 1 (must be a table with kind = \"sdof\", \"chain\", \"bar\", \"beam\", \"block\", "
     "\"mesh\", "
     "\"rotor\", \"shaft\" or \"matrices\")"},
    {"SineAtHarmonicZero", kContactFree, 9,
     "frequency = 1.0\n[[forcing.term]]\ndof = 0\nharmonic = 0\nsin = 0.5",
     "13: forcing.term[0].sin = 0.5 (must be 0 or absent: at harmonic 0 a sine is nothing)"},
    {"LawWithoutContact", kContactFree, 9, "frequency = 1.0\n[law]\nrestitution = 1",
     "10: law = {restitution = 1} (must be absent: the scene has no contact)"},
    {"EmptyTerms", kContactFree, 9, "frequency = 1.0\nterm = []",
     "10: forcing.term = [] (must be [[forcing.term]] tables; left out if there is none)"},
};

}  // namespace signorini::test
