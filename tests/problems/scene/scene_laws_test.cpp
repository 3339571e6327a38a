#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "problems/files/toml_tree.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini::scene_laws_test {
namespace {

const std::string kChain =
    "schema = 1\nname = \"chain\"\n[system]\nkind = \"chain\"\nmasses = [1.0, 1.0, 0.0]\ndampers = [0.1, "
    "0.1, "
    "0.0]\nsprings = [1.0, 1.0, 1.0]\n[forcing]\nfrequency = 1.0\n";

Problem read(const std::string& stops) { return parse_scene(kChain + stops, "chain.toml"); }

std::string refusal(const std::string& stops) {
  try {
    read(stops);
    return "";
  } catch (const SceneError& error) {
    return error.what();
  }
}

using Laws = std::vector<ContactLaw>;

Laws laws_of(const Problem& problem) {
  Laws laws;
  for (const Contact& contact : problem.contacts) laws.push_back(contact.law);
  return laws;
}

TEST(SceneLaws, ContactsHaveTheirOwnElseThatOfAll) {
  const Problem problem = read(
      "[[contact]]\ndof = 0\ngap = 0.1\n[[contact]]\ndof = 1\ngap = 0.1\npenalty = 5.0\n[[contact]]\ndof = "
      "2\ngap = 0.1\nmassless = true\n[law]\nrestitution = 0.5\n");
  EXPECT_EQ(laws_of(problem), (Laws{Restitution{0.5}, Spring{5.0}, Massless{}}));
  EXPECT_TRUE(std::holds_alternative<MixedLaws>(problem.law()));
}

TEST(SceneLaws, DampersMakeFacesOfTheirContactsAlone) {
  const Problem problem = read(
      "[[contact]]\ndof = 0\ngap = 0.1\nrestitution = 0.7\n[[contact]]\ndof = 1\ngap = 0.2\npenalty = "
      "5.0\ndamper = 0.5\n");
  ASSERT_EQ(problem.size(), 4);
  EXPECT_EQ(laws_of(problem), (Laws{Restitution{0.7}, Massless{}}));
  EXPECT_EQ(problem.contacts[1].normal, (std::vector<std::pair<int, double>>{{3, 1.0}}));
  EXPECT_EQ(problem.stiffness().coeff(3, 3), 5.0);
  EXPECT_EQ(problem.damping().coeff(1, 3), -0.5);
}

TEST(SceneLaws, ShortFormsStandForTheirContacts) {
  const Problem problem = read(
      "[[contact]]\nbetween = [0, 1]\nclearance = 0.1\npenalty = [3.0, 4.0]\n[[contact]]\ndof = 1\nside = "
      "\"below\"\ngap = 0.2\npenalty = 1.0\n");
  using Normal = std::vector<std::pair<int, double>>;
  ASSERT_EQ(problem.contacts.size(), 3U);
  EXPECT_EQ(problem.contacts[0].normal, (Normal{{0, 1.0}, {1, -1.0}}));
  EXPECT_EQ(problem.contacts[1].normal, (Normal{{0, -1.0}, {1, 1.0}}));
  EXPECT_EQ(problem.contacts[0].gap, 0.05);
  EXPECT_EQ(problem.contacts[1].gap, 0.05);
  EXPECT_EQ(problem.contacts[2].normal, (Normal{{1, -1.0}}));
  EXPECT_EQ(laws_of(problem), (Laws{Spring{3.0}, Spring{4.0}, Spring{1.0}}));
}

TEST(SceneLaws, RefusesWhatAContactCannotHave) {
  const auto own = [](const std::string& keys, int dof = 0) {
    return refusal("[[contact]]\ndof = " + std::to_string(dof) + "\ngap = 0.1\n" + keys);
  };
  EXPECT_EQ(own("restitution = 1.5\n"), "chain.toml:13: contact[0].restitution = 1.5 (must be in 0..1)");
  EXPECT_EQ(own("penalty = 0\n"), "chain.toml:13: contact[0].penalty = 0 (must be a positive number [N/m])");
  EXPECT_EQ(
      own("damper = 1.0\n"),
      "chain.toml:13: contact[0].damper = 1 (must be absent: no penalty, a spring beside it, is given)");
  EXPECT_EQ(own("penalty = 1.0\ndamper = 0.0\n"),
            "chain.toml:14: contact[0].damper = 0 (must be a positive number [N s/m])");
  EXPECT_EQ(
      own("massless = true\n"),
      "chain.toml:13: contact[0].massless = true (must be left out: the contact coordinate carries mass)");
  EXPECT_EQ(own("massless = false\n", 2),
            "chain.toml:13: contact[0].massless = false (must be true, or left out)");
  EXPECT_EQ(
      own("restitution = 0.5\n[[contact]]\ndof = 1\ngap = 0.1\n"),
      "chain.toml:14: contact[1].restitution = missing (required, in 0..1, unless a penalty is given: the "
      "contact coordinates carry mass)");
  EXPECT_EQ(own("clearance = -0.1\n"),
            "chain.toml:13: contact[0].clearance = -0.1 (must be a positive number [m])");
  EXPECT_EQ(own("side = \"left\"\n"),
            "chain.toml:13: contact[0].side = \"left\" (must be \"above\" or \"below\")");
  EXPECT_EQ(own("between = [0, 1]\n"),
            "chain.toml:13: contact[0].between = [0, 1] (must be absent: dof is given)");
}

TEST(SceneLaws, RefuseTwoRestitutionsAtOnePlace) {
  const std::string first = "[[contact]]\ndof = 0\ngap = 0.1\nrestitution = 0.8\n";
  EXPECT_EQ(
      refusal(first + "[[contact]]\nnormal = [[0, 2.0]]\ngap = 0.2\nrestitution = 0.5\n"),
      "chain.toml:17: contact[1].restitution = 0.5 (must be 0.8 as contact 0 has it, or its gap another "
      "one: contacts 0 and 1 stop the same motion at the same place, and Newton's law of impact takes one "
      "restitution)");
  EXPECT_EQ(refusal(first + first), "");
  EXPECT_EQ(refusal(first + "[[contact]]\ndof = 0\ngap = 0.1\npenalty = 5.0\n"), "");
  EXPECT_EQ(refusal(first + "[[contact]]\ndof = 0\ngap = 0.1\npenalty = 5.0\ndamper = 0.5\n"), "");
}

}  // namespace
}  // namespace signorini::scene_laws_test
