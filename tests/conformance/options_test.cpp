// Options of every method: declared, echoed, and no value whatever does worse than be refused.

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tests/conformance/method_case.hpp"

namespace signorini::options_test {
namespace {

class OptionsOf : public testing::TestWithParam<std::string> {
 protected:
  const MethodEntry& entry_ = find_method(GetParam());

  static void expect(const CheckResult& result) {
    EXPECT_EQ(result.outcome, CheckOutcome::passed) << result.why;
  }
};

TEST_P(OptionsOf, AreDeclaredWithUnitMeaningAndALadderThatIsAccepted) { expect(check_declaration(entry_)); }

TEST_P(OptionsOf, AreEchoedAsGiven) { expect(check_echo(entry_)); }

TEST_P(OptionsOf, AreRefusedInOneLineWhereTheyCannotBe) { expect(check_refusals(entry_)); }

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const MethodEntry& entry : method_catalogue()) names.emplace_back(entry.name);
  return names;
}

std::string camel_case(const testing::TestParamInfo<std::string>& info) {
  const std::string name = test::MethodCase{info.param, ""}.name();
  return name.substr(0, name.size() - 1);
}

INSTANTIATE_TEST_SUITE_P(Conformance, OptionsOf, testing::ValuesIn(method_names()), camel_case);

TEST(MethodCatalogue, NamesAreUnique) {
  std::set<std::string> seen;
  for (const MethodEntry& entry : method_catalogue())
    EXPECT_TRUE(seen.insert(std::string(entry.name)).second) << entry.name;
}

TEST(MethodCatalogue, EqualEquationsAreThoseOfAnotherMethodAndBelongToAValueOfAnOption) {
  for (const MethodEntry& entry : method_catalogue()) {
    EXPECT_EQ(same_equations_as(entry, {}), "") << entry.name;
    for (const SameEquations& same : entry.same_equations) {
      EXPECT_NE(find_method(same.method).name, entry.name);
      const OptionSetting setting{same.option, same.value};
      EXPECT_EQ(same_equations_as(entry, entry.make({&setting, 1})->options()), same.method) << entry.name;
    }
  }
  const MethodEntry& aft = find_method("aft-hbm");
  EXPECT_EQ(same_equations_as(aft, aft.make({})->options()), "fourier-lipschitz");
}

TEST(MethodCatalogue, AnUnknownNameIsRefusedWithTheNamesThereAre) {
  try {
    (void)find_method("time-machine");
    FAIL() << "accepted";
  } catch (const InvalidOption& refusal) {
    for (const MethodEntry& entry : method_catalogue()) {
      EXPECT_NE(std::string(refusal.what()).find(entry.name), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace signorini::options_test
