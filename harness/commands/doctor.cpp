#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "harness/commands/command_line.hpp"
#include "harness/doctor/machine.hpp"
#include "harness/table.hpp"
#include "harness/text/columns.hpp"
#include "harness/text/json.hpp"

namespace signorini {

namespace {

void print_table(const std::vector<MachineProperty>& properties) {
  Table table{{"what", "found", "times", "why, and what to do"}, {}};
  for (const MachineProperty& one : properties) {
    const std::string verdict = !one.known ? "-" : one.good ? "good" : "unreliable";
    table.rows.push_back({one.name, one.value, verdict, one.advice.empty() ? "nothing" : one.advice});
  }
  const auto bad = std::ranges::count(properties, false, &MachineProperty::good);
  fmt::print("{}\n{} of {} things make times unreliable here\n", to_columns(table, kTerminalWidth), bad,
             properties.size());
}

void print_json(const std::vector<MachineProperty>& properties) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const MachineProperty& one : properties) {
    nlohmann::ordered_json item{{"name", one.name}, {"value", one.value}, {"good", one.good}};
    if (!one.advice.empty()) item["advice"] = one.advice;
    list.push_back(std::move(item));
  }
  fmt::print("{}\n", json_text(list));
}

struct DoctorArguments {
  bool json = false;
};

void examine(const DoctorArguments& arguments) {
  std::vector<MachineProperty> properties = examine_system();
  std::ranges::move(examine_running(), std::back_inserter(properties));
  arguments.json ? print_json(properties) : print_table(properties);
}

}  // namespace

void add_doctor_command(const Command& program) {
  const auto [command, arguments] = program.command(
      "doctor", examine,
      "What makes times unreliable on this machine: governor, turbo, load, clock, other processes.");
  command.flag("--json", arguments->json, "print a JSON array");
}

}  // namespace signorini
