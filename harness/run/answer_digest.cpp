#include "harness/run/answer_digest.hpp"

#include <span>

#include "harness/files.hpp"

namespace signorini {

namespace {

void append(std::string& bytes, std::span<const double> values) {
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

void append(std::string& bytes, const Eigen::MatrixXd& values) {
  append(bytes, std::span(values.data(), static_cast<std::size_t>(values.size())));
}

}  // namespace

std::string answer_digest(const Trajectory& answer) {
  constexpr int kInstants = 64;
  constexpr std::size_t kDigits = 16;
  std::string bytes;
  const double period = answer.period();
  append(bytes, std::span(&period, 1));
  const Samples samples = answer.sample(kInstants);
  for (const Eigen::MatrixXd* values : {&samples.x, &samples.velocity, &samples.force})
    append(bytes, *values);
  for (const Impulse& impulse : answer.impulses()) {
    bytes += std::to_string(impulse.contact);
    append(bytes, std::span(&impulse.time, 1));
    append(bytes, std::span(&impulse.value, 1));
  }
  return sha256(bytes).substr(0, kDigits);
}

}  // namespace signorini
